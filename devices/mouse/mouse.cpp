#include "devices/mouse/mouse.hpp"

#include "base/threads/snapshot.hpp"
#include "devices/mouse/pseudo_haptic.hpp"

namespace palpate::devices {
namespace {

constexpr double kFieldHeight = 15e-3;  // of the page's field: 480 px, 32 px for a millimetre [m]
constexpr double kPageRate = 60.0;      // a sample with each picture that the page paints [Hz]

struct PagePointer {
  double depth = 0.0;         // along the press [m]
  std::int64_t measured = 0;  // monotonic clock [ns]
  bool known = false;
};

struct Mouse : Handle {
  base::Snapshot<PagePointer> told;  // by the thread that hears the page
  PagePointer newest;                // the loop's
};

std::unique_ptr<Handle> open_mouse(const std::string&) {
  return std::make_unique<Mouse>();
}

void tell_mouse(Handle& handle, std::optional<double> depth, std::int64_t now) {
  static_cast<Mouse&>(handle).told.write(depth ? PagePointer{.depth = *depth, .measured = now, .known = true}
                                               : PagePointer{});
}

Reading read_mouse(Handle& handle, const Moment& moment) {
  auto& mouse = static_cast<Mouse&>(handle);
  mouse.newest = mouse.told.try_read().value_or(mouse.newest);
  return {.position = mouse.newest.depth * moment.press,
          .measured = mouse.newest.measured,
          .known = mouse.newest.known};
}

void move_with_mouse(DrivenProbe& probe, const Vec3& target, double force, double step) {
  follow_hand({}, probe, target.dot(probe.direction), force, step);
  probe.displacement = probe.depth * probe.direction;
}

}  // namespace

const Device& mouse() {
  static const Device device{
      .name = "mouse",
      .in_words = "a mouse",
      .notice = "A mouse gives no force: this session is pseudo-haptic, its channel is the pointer's lag.",
      .argument = "",
      .facts = {.channel = "pointer lag", .workspace = {0, 0, kFieldHeight}, .rate = kPageRate},
      .open = open_mouse,
      .read = read_mouse,
      .move = move_with_mouse,
      .tell = tell_mouse};
  return device;
}

}  // namespace palpate::devices
