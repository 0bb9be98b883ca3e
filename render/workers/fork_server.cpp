#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iterator>
#include <map>
#include <system_error>

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include "base/error.h"
#include "render/workers/messages.h"
#include "render/workers/worker_process.h"

namespace tribolog::render::workers {

// Handing an open file descriptor to the process at the other end of a local socket.

namespace {

/// One byte of text, without which a descriptor does not travel, and room for one descriptor.
struct Envelope {
  char text{'d'};
  iovec content{&text, sizeof text};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr header{};

  Envelope() {
    header.msg_iov = &content;
    header.msg_iovlen = 1;
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
  Envelope(const Envelope&) = delete;
  Envelope& operator=(const Envelope&) = delete;
};

/// Sends a duplicate of the descriptor; the caller keeps its own. False if the other side is gone.
bool send_descriptor(int socket, int descriptor) {
  Envelope envelope;
  cmsghdr* item = CMSG_FIRSTHDR(&envelope.header);
  item->cmsg_level = SOL_SOCKET;
  item->cmsg_type = SCM_RIGHTS;
  item->cmsg_len = CMSG_LEN(sizeof descriptor);
  std::memcpy(CMSG_DATA(item), &descriptor, sizeof descriptor);
  ssize_t sent = 0;
  do {
    sent = sendmsg(socket, &envelope.header, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent == 1;
}

/// Blocks until one arrives. The caller owns it; it is closed on exec. -1 if the other side is gone
/// or sent something else.
int receive_descriptor(int socket) {
  Envelope envelope;
  ssize_t got = 0;
  do {
    got = recvmsg(socket, &envelope.header, MSG_CMSG_CLOEXEC);
  } while (got < 0 && errno == EINTR);
  const cmsghdr* item = got == 1 ? CMSG_FIRSTHDR(&envelope.header) : nullptr;
  if (item == nullptr || item->cmsg_level != SOL_SOCKET || item->cmsg_type != SCM_RIGHTS) return -1;
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(item), sizeof descriptor);
  return descriptor;
}

enum Command : std::uint32_t { start_worker_command, end_worker_command };

/// Nothing where /proc does not tell.
bool has_one_thread() {
  std::error_code error;
  std::filesystem::directory_iterator threads("/proc/self/task", error);
  return !error && std::distance(begin(threads), end(threads)) == 1;
}

Message number_message(std::uint32_t number) {
  Message message;
  message.put(number);
  return message;
}

/// The server's side.
class Server {
 public:
  Server(int owner, const std::function<void(int)>& serve) : owner_(owner), serve_(serve) {}

  void run() {
    while (auto request = receive_message(owner_)) {
      const std::uint32_t command = request->take_number();
      const std::uint32_t number = request->take_number();
      if (command == start_worker_command ? !start(number) : !end(number)) return;
    }
  }

 private:
  bool start(std::uint32_t number) {
    std::unique_ptr<WorkerProcess> worker;
    Message answer;
    try {
      worker = std::make_unique<WorkerProcess>([this](int socket) {
        close(owner_);
        serve_(socket);
      });
      put_statement(answer, {});
    } catch (const std::exception& problem) {
      put_statement(answer, stated_by(problem));
    }
    if (!send_message(owner_, answer)) return false;
    if (!worker) return true;
    const bool sent = send_descriptor(owner_, worker->socket());
    // From here on only the owner holds it: a worker that ends is then seen by the owner.
    worker->close_socket();
    workers_[number] = std::move(worker);
    return sent;
  }

  bool end(std::uint32_t number) {
    Message answer;
    put_statement(answer, workers_.at(number)->end_and_explain());
    workers_.erase(number);
    return send_message(owner_, answer);
  }

  int owner_;
  const std::function<void(int)>& serve_;
  std::map<std::uint32_t, std::unique_ptr<WorkerProcess>> workers_;
};

}  // namespace

ForkServer::ForkServer(const std::function<void()>& prepare, const std::function<void(int)>& serve)
    : process_([&](int socket) {
        prepare();
        if (send_message(socket, number_message(has_one_thread() ? 1 : 0))) {
          Server(socket, serve).run();
        }
      }) {}

ForkServer::~ForkServer() {
  // A server that is still preparing has no workers to see off.
  if (is_prepared_) process_.end_gently(std::chrono::milliseconds(500));
}

ForkServer::Readiness ForkServer::wait(std::chrono::milliseconds most) {
  pollfd server{process_.socket(), POLLIN, 0};
  const auto deadline = std::chrono::steady_clock::now() + most;
  int found = 0;
  do {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    found = poll(&server, 1, static_cast<int>(std::clamp<long long>(left.count(), 0, 1 << 30)));
  } while (found < 0 && errno == EINTR);
  if (found == 0) throw FigureError({"drawing.start_took_too_long"});
  auto answer = receive_message(process_.socket());
  if (!answer) lost();
  is_prepared_ = true;
  return answer->take_number() == 1 ? Readiness::ready : Readiness::has_threads;
}

void ForkServer::lost() {
  throw FigureError({"drawing.process_lost", {{"end", process_.end_and_explain()}}});
}

std::unique_ptr<ForkServer::Worker> ForkServer::start_worker() {
  const std::uint32_t number = started_++;
  Message request;
  request.put(start_worker_command);
  request.put(number);
  send_message(process_.socket(), request);
  auto answer = receive_message(process_.socket());
  if (!answer) lost();
  const Statement problem = take_statement(*answer);
  if (!problem.empty()) throw FigureError(problem);
  const int socket = receive_descriptor(process_.socket());
  if (socket < 0) lost();
  return std::make_unique<Worker>(*this, number, socket);
}

Statement ForkServer::end_worker(std::uint32_t number) {
  Message request;
  request.put(end_worker_command);
  request.put(number);
  send_message(process_.socket(), request);
  auto answer = receive_message(process_.socket());
  return answer ? take_statement(*answer) : process_.end_and_explain();
}

ForkServer::Worker::Worker(ForkServer& server, std::uint32_t number, int socket)
    : server_(server), number_(number), socket_(socket) {}

ForkServer::Worker::~Worker() { close(socket_); }

Statement ForkServer::Worker::end_and_explain() { return server_.end_worker(number_); }

}  // namespace tribolog::render::workers
