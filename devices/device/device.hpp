#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "devices/device/driven_probe.hpp"

namespace palpate::devices {

/// What a device can do, as its maker or its program states it. Sessions are marked by it.
struct DeviceFacts {
  bool moved_by_a_person = true;  // else what it plays is no examinee's
  bool gives_force = false;       // else the session is pseudo-haptic
  std::string_view channel{};     // what carries the stimulus to a person where no force does; else empty
  Vec3 workspace = Vec3::Zero();  // extents of where the hand can be, the last one along the press [m];
                                  // 0: it does not move there
  double continuous_force = 0.0;  // largest that it can hold [N]
  double peak_force = 0.0;        // [N]
  double stiffness = 0.0;         // largest that it can render stably [N/m]
  double rate = 0.0;              // of new positions [Hz]
};

/// When and for what a device is read.
struct Moment {
  std::int64_t now = 0;        // monotonic clock [ns]
  double since_begin = 0.0;    // of the interval, in whole cycles of the loop [s]
  Vec3 press = Vec3::UnitZ();  // direction in which the probe presses, unit length
};

/// The hand's newest pose.
struct Reading {
  Vec3 position = Vec3::Zero();    // from where the probe rests [m]
  std::optional<Vec3> rotation{};  // rotation vector [rad]; nothing from a device that cannot tell
  std::int64_t measured = 0;       // monotonic clock [ns]
  bool known = false;              // false while nothing has been measured
};

/// What an open device keeps: its connection, its newest sample.
struct Handle {
  virtual ~Handle() = default;
};

/// A kind of device, as functions and facts. `open` may take its time and throws where there is no such
/// device or its argument is wrong; everything else is called from the haptic loop and neither allocates,
/// locks nor waits, but `tell`, which any one other thread may call meanwhile.
struct Device {
  std::string_view name{};      // in --device, in the session's row
  std::string_view in_words{};  // in help: "a mouse"
  std::string_view notice{};    // what the technician is told as a session begins; may be empty
  std::string_view argument{};  // what follows the name behind a colon ("FILE"); empty: nothing may
  DeviceFacts facts{};

  std::unique_ptr<Handle> (*open)(const std::string& argument) = nullptr;
  Reading (*read)(Handle& handle, const Moment& moment) = nullptr;
  /// Moves the probe on by `step` [s] after the hand at `target` [m]. @param force  at probe.depth [N]
  void (*move)(DrivenProbe& probe, const Vec3& target, double force, double step) = nullptr;
  /// Gives the hand a force [N], no larger than facts.continuous_force. Null where facts say that it gives
  /// none.
  void (*deliver)(Handle& handle, const Vec3& force) = nullptr;
  /// Where the hand is along the press [m], or that this is not known any more: for a device whose hand comes
  /// through the examinee's page, else null.
  void (*tell)(Handle& handle, std::optional<double> depth, std::int64_t now) = nullptr;
};

/// A device that is ready to be read.
struct OpenDevice {
  const Device* device = nullptr;
  std::unique_ptr<Handle> handle{};
};

}  // namespace palpate::devices
