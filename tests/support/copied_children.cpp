// Under ThreadSanitizer the processes that Qt starts get a copy of this program's memory. Qt starts
// them by clone() within this memory. What ThreadSanitizer then switches off for the child stays
// off for the parent's thread, whose locks are no longer seen: every hand over looks like a race.
#include <cstdarg>

#include <sched.h>
#include <sys/types.h>

extern "C" {

/// ThreadSanitizer's own.
int __interceptor_clone(int (*)(void*), void*, int, void*, pid_t*, void*, pid_t*);

int clone(int (*child)(void*), void* stack, int flags, void* argument, ...) noexcept {
  va_list further;
  va_start(further, argument);
  auto* parents_id = va_arg(further, pid_t*);
  auto* storage = va_arg(further, void*);
  auto* childs_id = va_arg(further, pid_t*);
  va_end(further);
  return __interceptor_clone(child, stack, flags & ~(CLONE_VM | CLONE_VFORK), argument, parents_id,
                             storage, childs_id);
}
}
