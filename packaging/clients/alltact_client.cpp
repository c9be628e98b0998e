// A client of `alltact serve` in C++ and POSIX alone: prints the deepest micrometre of each frame.
//   c++ -std=c++17 alltact_client.cpp -o alltact_client && ./alltact_client SOCKET
// `alltact serve --schema` prints the format of all messages.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

struct Header {
  char magic[4];
  std::uint16_t version, type;
  std::uint32_t parts, json_bytes;
  std::uint64_t bytes, sequence, time_ns, lost;
};
struct Part {
  char name[16], dtype[4];
  std::uint32_t rows, cols, channels;
  std::uint64_t offset, bytes;
};

static bool read_all(int server, void* into, std::size_t size) {
  return size == 0 || recv(server, into, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

int main(int argc, char** argv) {
  sockaddr_un path{AF_UNIX, {}};
  if (argc == 2) std::strncpy(path.sun_path, argv[1], sizeof path.sun_path - 1);
  const int server = socket(AF_UNIX, SOCK_STREAM, 0);
  if (connect(server, reinterpret_cast<sockaddr*>(&path), sizeof path) != 0 ||
      write(server, "alltact-stream/1 depth16\n", 25) != 25)
    return std::perror("the server cannot be reached"), 1;
  std::vector<char> body;
  for (Header head{}; read_all(server, &head, sizeof head);) {
    body.resize(head.bytes);
    if (!read_all(server, body.data(), body.size())) return 1;
    const Part* part = reinterpret_cast<const Part*>(body.data());
    if (head.type == 2 && head.parts == 1) {
      const auto* depth = reinterpret_cast<const std::uint16_t*>(body.data() + part->offset);
      const int deepest =
          *std::max_element(depth, depth + std::size_t{part->rows} * part->cols) - 10000;
      std::printf("frame %lu: %d um, %lu frames lost\n", head.sequence, deepest, head.lost);
    } else {
      const char* json = body.data() + head.parts * sizeof(Part);
      std::printf("%.*s\n", static_cast<int>(head.json_bytes), json);
    }
    if (head.type > 3) return head.type == 4 ? 0 : 1;
  }
  return 1;
}
