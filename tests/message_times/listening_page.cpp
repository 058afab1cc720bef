#include "tests/message_times/listening_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <thread>

#include "app/web/host/kept_link.hpp"

namespace palpate::app::message_times {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kHandPeriod = 8ms;
constexpr auto kRest = 60ms;  // before "go on" is said, as a person rests

double ms(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// A page without a screen: says what an examinee would, and notes when it hears what.
class ListeningPage {
 public:
  ListeningPage(const KeptLink& link, double asked) : deepest_(1.3 * asked) {
    socket_.next_layer().connect({asio::ip::address_v4::loopback(), link.port});
    socket_.next_layer().set_option(asio::ip::tcp::no_delay(true));
    const std::string host = fmt::format("127.0.0.1:{}", link.port);
    socket_.set_option(websocket::stream_base::decorator(
        [&](websocket::request_type& request) { request.set("Origin", "http://" + host); }));
    socket_.handshake(host, fmt::format("/{}/live", link.token));
  }

  std::vector<IntervalTimes> sit() {
    read();
    io_.run_for(300s);
    if (!done_) throw std::runtime_error("the sitting came to no end");
    return intervals_;
  }

 private:
  void read() {
    socket_.async_read(buffer_, [this](boost::system::error_code error, std::size_t) {
      if (error) return io_.stop();  // the program has said its last word
      const Clock::time_point now = Clock::now();
      const std::string message = boost::beast::buffers_to_string(buffer_.data());
      buffer_.clear();
      if (socket_.got_text())
        phase(nlohmann::json::parse(message), now);
      else
        binary(message, now);
      read();
    });
  }

  void phase(const nlohmann::json& message, Clock::time_point now) {
    const std::string before = phase_;
    phase_ = message.at("phase");
    id_ = message.at("id");
    if (before == "interval") ended(now);
    if (phase_ == "interval") return begun(now);
    if (phase_ == "pause") paused_ = now;
    if (phase_ == "end") done_ = true;
    if (phase_ == "pause" || phase_ == "end") return;
    timer_.expires_after(kRest);
    timer_.async_wait([this](boost::system::error_code error) {
      if (!error) reply();
    });
  }

  void reply() {
    nlohmann::json said = {{"type", "continue"}, {"id", id_}};
    if (phase_ == "question") said.update({{"type", "answer"}, {"choice", 1}, {"ms", 20.0}});
    if (phase_ == "thanks") said.update({{"type", "strategy"}, {"text", ""}});
    started_ = Clock::now();
    write(said.dump(), true);
  }

  void begun(Clock::time_point now) {
    IntervalTimes& times = intervals_.emplace_back();
    if (paused_)
      times.from_pause = ms(now - *paused_);
    else
      times.from_start = ms(now - started_);
    shown_ = now;
    gaps_.clear();
    last_probe_.reset();
    over_.reset();
    pressed_.reset();
    move(now);
  }

  /// The hand's next place: up, one press of 0.3 s, up.
  void move(Clock::time_point when) {
    timer_.expires_at(when);
    timer_.async_wait([this, when](boost::system::error_code error) {
      if (error || phase_ != "interval") return;
      const double t = ms(when - shown_) - 100;
      const bool pressing = t > 0 && t < 300;
      const double share = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * t / 300);
      hand(pressing ? -1e-3 + (deepest_ + 1e-3) * share : -1e-3);
      if (pressing && !pressed_) pressed_ = Clock::now();
      move(when + kHandPeriod);
    });
  }

  void hand(double metres) {
    std::string bytes(12, '\0');
    bytes[0] = 1;
    const auto micrometres = static_cast<std::int32_t>(std::lround(1e6 * metres));
    std::memcpy(bytes.data() + 4, &id_, 4);
    std::memcpy(bytes.data() + 8, &micrometres, 4);
    write(bytes, false);
  }

  void binary(const std::string& bytes, Clock::time_point now) {
    if (phase_ != "interval" || bytes.at(0) != 2) return;
    if (last_probe_)
      gaps_.push_back(ms(now - *last_probe_));
    else
      intervals_.back().first_probe = ms(now - shown_);
    last_probe_ = now;
    if ((static_cast<unsigned char>(bytes.at(1)) & 4U) != 0 && !over_) over_ = now;
  }

  void ended(Clock::time_point now) {
    IntervalTimes& times = intervals_.back();
    std::ranges::sort(gaps_);
    if (!gaps_.empty()) {
      times.longest_gap = gaps_.back();
      times.typical_gap = gaps_[gaps_.size() / 2];
    }
    if (over_ && pressed_) times.to_over = ms(*over_ - *pressed_);
    if (over_) times.to_outcome = ms(now - *over_);
    paused_.reset();
  }

  void write(const std::string& bytes, bool text) {
    socket_.text(text);
    socket_.write(asio::buffer(bytes));
  }

  double deepest_;
  asio::io_context io_;
  websocket::stream<asio::ip::tcp::socket> socket_{io_};
  asio::steady_timer timer_{io_};
  boost::beast::flat_buffer buffer_;
  std::vector<IntervalTimes> intervals_;
  std::string phase_;
  std::uint32_t id_ = 0;
  Clock::time_point started_{}, shown_{};
  std::optional<Clock::time_point> paused_{}, last_probe_{}, over_{}, pressed_{};
  std::vector<double> gaps_;
  bool done_ = false;
};

}  // namespace

std::vector<IntervalTimes> sit_through(const std::filesystem::path& link, double asked) {
  std::optional<KeptLink> kept;
  for (int i = 0; i < 1000 && !kept; ++i) {
    kept = read_kept_link(link);
    if (!kept) std::this_thread::sleep_for(10ms);
  }
  if (!kept) throw std::runtime_error("no page was served");
  return ListeningPage(*kept, asked).sit();
}

}  // namespace palpate::app::message_times
