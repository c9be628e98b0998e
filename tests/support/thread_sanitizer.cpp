// What ThreadSanitizer reports of Debian's libraries, which were built without it: it cannot see
// the atomics with which libav's own threads hand over their buffers, and takes GDAL's locks,
// created one inside the other when OpenCV first looks for decoders, for a circle.
#if defined(__SANITIZE_THREAD__)
extern "C" const char* __tsan_default_suppressions() {  // NOLINT: its name is the sanitizer's
  return "race:libavcodec.so\n"
         "race:libavutil.so\n"
         "deadlock:libgdal.so\n";
}
#endif
