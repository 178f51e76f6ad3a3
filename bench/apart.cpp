// SPDX-License-Identifier: LGPL-3.0-or-later
#include "apart.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string_view>
#include <system_error>

namespace gcv::bench {

namespace {

constexpr rlim_t most_memory = rlim_t{12} << 30;

// The first byte that comes through the pipe.
constexpr char is_result = '+';
constexpr char is_failure = '-';

bool write_all(int out, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(out, bytes.data(), bytes.size());
    if (written <= 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string read_all(int in) {
  std::string bytes;
  std::array<char, 65536> buffer;
  for (ssize_t got = 0; (got = read(in, buffer.data(), buffer.size())) > 0;) {
    bytes.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return bytes;
}

std::string caught(const std::function<std::string()>& function) {
  try {
    return is_result + function();
  } catch (const std::exception& exception) {
    return std::string(1, is_failure) + "error: " + exception.what();
  }
}

[[noreturn]] void child(double limit, const std::function<std::string()>& function, int out) {
  const rlimit memory{most_memory, most_memory};
  setrlimit(RLIMIT_AS, &memory);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const auto seconds = static_cast<rlim_t>(std::ceil(limit));
  const rlimit time{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  _exit(write_all(out, caught(function)) ? 0 : 1);
}

Outcome failed(int status, double limit) {
  Outcome outcome;
  std::array<char, 64> text{};
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    outcome.is_cut_off = true;
    std::snprintf(text.data(), text.size(), "> %.0f s", limit);
  } else if (WIFSIGNALED(status)) {
    std::snprintf(text.data(), text.size(), "crash: %s", strsignal(WTERMSIG(status)));
  } else {
    std::snprintf(text.data(), text.size(), "exit status %d", WEXITSTATUS(status));
  }
  outcome.failure = text.data();
  return outcome;
}

}  // namespace

Outcome run_apart(double limit, const std::function<std::string()>& function) {
  int ends[2];
  if (pipe(ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const pid_t process = fork();
  if (process < 0) {
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  if (process == 0) {
    child(limit, function, ends[1]);
  }
  close(ends[1]);
  std::string bytes = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(process, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) {
    return failed(status, limit);
  }
  const bool has_failed = bytes.front() == is_failure;
  bytes.erase(0, 1);
  return has_failed ? Outcome{"", bytes, false} : Outcome{bytes, "", false};
}

}  // namespace gcv::bench
