#include "app/web/host/host.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/command_line/open_browser.hpp"
#include "app/loop/haptic_loop.hpp"
#include "app/web/host/kept_link.hpp"
#include "app/web/pages/pages.hpp"
#include "app/web/server/access.hpp"
#include "app/web/server/frames.hpp"
#include "app/web/server/server.hpp"

namespace palpate::app {
namespace {

namespace asio = boost::asio;
using namespace std::chrono_literals;

constexpr auto kPollPeriod = 16ms;    // about a screen's refresh
constexpr auto kLastWord = 500ms;     // for the last page to arrive
constexpr auto kPageMayReturn = 10s;  // once all is answered

void say(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

struct Host::State {
  explicit State(const HostOptions& wanted) : options(wanted), server(serve()) {}

  std::unique_ptr<Server> serve();
  std::unique_ptr<Server> serve_at(std::uint16_t port, const std::string& token);

  template <typename Member, typename... Arguments>
  void with(Member member, Arguments... arguments) {
    if (sitting) (*sitting.*member)(arguments...);
  }

  void poll_at(std::chrono::steady_clock::time_point when);
  void stop_if_alone(std::chrono::steady_clock::time_point now);
  void stop_after(std::chrono::milliseconds time);
  void announce(const HapticLoop& loop);

  HostOptions options;
  asio::io_context io;
  asio::signal_set signals{io, SIGINT, SIGTERM, SIGHUP};
  asio::steady_timer poll_timer{io}, stop_timer{io};
  std::optional<std::chrono::steady_clock::time_point> alone_since;
  std::unique_ptr<Server> server;
  std::optional<Sitting> sitting;
};

std::unique_ptr<Server> Host::State::serve_at(std::uint16_t port, const std::string& token) {
  return std::make_unique<Server>(
      io, page("examinee"), port, token,
      PageEvents{[this] { with(&Sitting::page_opened); },
                 [this](std::string_view text) { with(&Sitting::text_from_page, text); },
                 [this](std::string_view bytes) { with(&Sitting::binary_from_page, bytes); },
                 [this] { with(&Sitting::page_closed); }});
}

/// Where the page of this sitting was before, so that one left open goes on; else anew.
std::unique_ptr<Server> Host::State::serve() {
  const auto kept = read_kept_link(options.kept_link);
  if (kept && kept->sitting == options.sitting && (options.port == 0 || options.port == kept->port)) {
    try {
      return serve_at(kept->port, kept->token);
    } catch (const std::runtime_error&) {  // another program has the port by now
    }
  }
  return serve_at(options.port, draw_token());
}

void Host::State::poll_at(std::chrono::steady_clock::time_point when) {
  poll_timer.expires_at(when);
  poll_timer.async_wait([this, when](boost::system::error_code error) {
    if (error) return;
    sitting->poll(when);
    stop_if_alone(when);
    const auto late = std::chrono::steady_clock::now() - when;
    poll_at(when + (1 + late / kPollPeriod) * kPollPeriod);  // always on one beat, whatever a poll took
  });
}

/// All is answered and nobody is there to say how: the last page was closed.
void Host::State::stop_if_alone(std::chrono::steady_clock::time_point now) {
  if (!sitting->complete() || server->connected()) return alone_since.reset();
  if (!alone_since) alone_since = now;
  if (now - *alone_since > kPageMayReturn) io.stop();
}

void Host::State::stop_after(std::chrono::milliseconds time) {
  stop_timer.expires_after(time);
  stop_timer.async_wait([this](boost::system::error_code error) {
    if (!error) io.stop();
  });
}

void Host::State::announce(const HapticLoop& loop) {
  say(loop.real_time() ? "Haptic loop: 1 kHz, real-time scheduling (SCHED_FIFO)."
                       : "Haptic loop: 1 kHz, ordinary scheduling (SCHED_FIFO is not permitted here).");
  if (!loop.device().notice.empty()) say(std::string(loop.device().notice));
  std::printf("%s\n", server->link().c_str());
  std::fflush(stdout);
  if (!options.open_browser)
    say("Open this link in a browser on this machine. Ctrl-C pauses the session.");
  else if (open_browser(server->link()))
    say("The link opens in the browser; if it does not, open it by hand. Ctrl-C pauses the session.");
  else
    say("No browser could be started: open this link in one on this machine. Ctrl-C pauses the session.");
}

Host::Host(const HostOptions& options) : state_(std::make_unique<State>(options)) {}
Host::~Host() = default;

HostEnd Host::lead(trials::Session& session, const trials::Protocol& protocol, const Organs& organs,
                   devices::OpenDevice device) {
  State& state = *state_;
  HapticLoop loop(std::move(device));
  FrameStream frames([&state](const std::string& jpeg) {
    asio::post(state.io, [&state, bytes = encode_frame(jpeg)] { state.server->send_binary(bytes); });
  });
  state.sitting.emplace(
      session, protocol, organs, loop, &frames,
      Outlets{.text = [&](std::string message) { state.server->send_text(std::move(message)); },
              .binary = [&](std::string message) { state.server->send_binary(std::move(message)); },
              .technician = say,
              .finished =
                  [&] {
                    state.server->finish();
                    state.stop_after(kLastWord);
                  }});
  bool interrupted = false;
  state.signals.async_wait([&](boost::system::error_code error, int) {
    if (error) return;
    interrupted = true;
    state.io.stop();
  });
  keep_link(state.options.kept_link,
            {.sitting = state.options.sitting, .port = state.server->port(), .token = state.server->token()});
  state.announce(loop);
  state.poll_at(std::chrono::steady_clock::now());
  try {
    state.io.run();
  } catch (...) {
    state.sitting.reset();  // before the loop and the frames that it uses
    throw;
  }
  if (interrupted) state.sitting->interrupt("stopped by the technician");
  if (const std::string failure = frames.failure(); !failure.empty())
    say(fmt::format("There were no pictures of the organs: {}", failure));
  const bool complete = state.sitting->complete();
  state.sitting.reset();
  if (std::error_code ignored; complete) std::filesystem::remove(state.options.kept_link, ignored);
  return complete ? HostEnd::Complete : HostEnd::Stopped;
}

}  // namespace palpate::app
