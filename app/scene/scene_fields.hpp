// The scene file's keys, in one table per section; shapes hold their own tables as a member
// `fields`. The reader, the resolved dump, the JSON schema and the hash are all made from these
// tables.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <variant>

#include "app/scene/scene.hpp"
#include "app/tables/table.hpp"

namespace spindrift::app {

template <>
inline constexpr std::array<std::string_view, 2> value_names<sim::SolverType>{"pcisph", "sph"};
template <>
inline constexpr std::array<std::string_view, 3> value_names<sim::Backend>{"auto", "cpu", "cuda"};
template <>
inline constexpr std::array<std::string_view, 2> value_names<sim::PressureKernel>{"cubic", "spiky"};
template <>
inline constexpr std::array<std::string_view, 2> value_names<sim::Interpolation>{"smooth",
                                                                                 "linear"};
template <>
inline constexpr std::array<std::string_view, 2> value_names<gl::Style>{"mesh", "particles"};
template <>
inline constexpr std::array<std::string_view, 3> value_names<gl::ColorBy>{"speed", "density",
                                                                          "pressure"};

template <>
inline constexpr std::array<std::string_view, 6> value_names<sim::Direction>{"+x", "-x", "+y",
                                                                             "-y", "+z", "-z"};

template <>
inline constexpr std::string_view variant_name<sim::Shape> = "shape";
template <>
inline constexpr std::string_view variant_name<sim::Opening> = "opening";
template <>
inline constexpr std::array<std::string_view, std::variant_size_v<sim::Opening>>
    alternative_names<sim::Opening>{"disc", "rectangle"};
template <>
inline constexpr std::string_view variant_name<sim::ProbeQuantity> = "quantity";
template <>
inline constexpr std::array<std::string_view, std::variant_size_v<sim::ProbeQuantity>>
    alternative_names<sim::ProbeQuantity>{"surface_height", "pressure", "front", "energy",
                                          "volume"};

inline constexpr Range speeds{-1e3, 1e3};  // m/s
inline constexpr Range times{0., 1e5};     // s
inline constexpr Range colors{0., 1.};
inline constexpr Range accelerations{-1e4, 1e4};  // m/s²
inline constexpr Range turns{-1e6, 1e6};          // degrees

template <>
inline constexpr auto table<sim::Volume> =
    std::tuple{Field{"", &sim::Volume::shape},
               Field{"velocity", &sim::Volume::velocity, "initial velocity", speeds, "m/s"}};

template <>
inline constexpr auto table<sim::Disc> = std::tuple{
    Field{"center", &sim::Disc::center, "centre of the opening", places, "m", Presence::required},
    Field{"direction", &sim::Disc::direction, "the way the liquid goes", directions, "",
          Presence::required},
    Field{"radius", &sim::Disc::radius, "of the opening", lengths, "m", Presence::required}};

template <>
inline constexpr auto table<sim::Rectangle> = std::tuple{
    Field{"center", &sim::Rectangle::center, "centre of the opening", places, "m",
          Presence::required},
    Field{"direction", &sim::Rectangle::direction, "the way the liquid goes", directions, "",
          Presence::required},
    Field{"up", &sim::Rectangle::up, "the way of its height, as far as across the direction",
          directions},
    Field{"width", &sim::Rectangle::width, "across up", lengths, "m", Presence::required},
    Field{"height", &sim::Rectangle::height, "along up", lengths, "m", Presence::required}};

template <>
inline constexpr auto table<sim::Emitter> = std::tuple{
    Field{"", &sim::Emitter::opening},
    Field{"speed", &sim::Emitter::speed,
          "of the liquid in the opening; area times speed is the volume that comes per second",
          Range{1e-3, 1e3}, "m/s"},
    Field{"from", &sim::Emitter::from, "when the first liquid comes out", times, "s"},
    Field{"to", &sim::Emitter::to, "when it ends", times, "s"},
    Field{"max_particles", &sim::Emitter::max_particles,
          "it also ends after so many, whole layers; 0: any number", Range{0, 2e8}}};

template <>
inline constexpr auto table<sim::FluidSettings> = std::tuple{
    Field{"spacing", &sim::FluidSettings::spacing,
          "distance between particle centres at rest, fitted to the volumes", Range{1e-6, 100.},
          "m"},
    Field{"rest_density", &sim::FluidSettings::rest_density, "density of the liquid at rest",
          Range{1e-3, 1e5}, "kg/m³"},
    Field{"viscosity", &sim::FluidSettings::viscosity, "dynamic viscosity", Range{0., 1e4}, "Pa·s"},
    Field{"wall_viscosity", &sim::FluidSettings::wall_viscosity,
          "with which walls and obstacles hold the liquid back; 0: it slips; as much as viscosity: "
          "it "
          "sticks (no-slip)",
          Range{0., 1e4}, "Pa·s"},
    Field{"surface_tension", &sim::FluidSettings::surface_tension,
          "surface tension against the air; 0: none; water has 0.072", Range{0., 1e4}, "N/m"},
    Field{"contact_angle", &sim::FluidSettings::contact_angle,
          "angle at which liquid with surface tension meets walls and obstacles; 180: they are as "
          "air to it",
          Range{90., 180.}, "degrees"},
    Field{"volumes", &sim::FluidSettings::volumes,
          "regions filled with liquid at the start, but for what obstacles take up; particles on a "
          "lattice that fits a box from face to face; none if there are only emitters"},
    Field{"emitters", &sim::FluidSettings::emitters,
          "openings that liquid enters through; each has a nozzle of four spacings behind it"}};

template <>
inline constexpr auto table<sim::DomainSettings> =
    std::tuple{Field{"min", &sim::DomainSettings::min, "lowest corner, inner faces", places, "m"},
               Field{"max", &sim::DomainSettings::max, "highest corner, inner faces", places, "m"},
               Field{"open", &sim::DomainSettings::open,
                     "faces without a wall, by the way out through them, such as [\"+y\"]"}};

template <>
inline constexpr auto table<sim::MotionKey> = std::tuple{
    Field{"time", &sim::MotionKey::time, "time of the key", times, "s", Presence::required},
    Field{"translate", &sim::MotionKey::translate, "how far the body is then from where it was put",
          places, "m"},
    Field{"rotate", &sim::MotionKey::rotate,
          "angles about the x, then the y, then the z axis, through the pivot", turns, "degrees"}};

template <>
inline constexpr auto table<sim::Oscillation> = std::tuple{
    Field{"translate", &sim::Oscillation::translate, "amplitude of the translation", places, "m"},
    Field{"rotate", &sim::Oscillation::rotate,
          "amplitudes of the angles about the x, y and z axes through the pivot", turns, "degrees"},
    Field{"frequency", &sim::Oscillation::frequency, "swings per second", Range{0., 1e3}, "Hz",
          Presence::required},
    Field{"phase", &sim::Oscillation::phase,
          "at time 0, where 0 is the middle of the swing and 90 its end, at rest", turns,
          "degrees"}};

template <>
inline constexpr auto table<sim::Spin> =
    std::tuple{Field{"axis",
                     &sim::Spin::axis,
                     "direction of the axis, which goes through the pivot",
                     directions,
                     {},
                     Presence::required},
               Field{"frequency", &sim::Spin::frequency,
                     "turns per second, counter-clockwise seen from the axis' tip",
                     Range{-1e3, 1e3}, "1/s", Presence::required}};

template <>
inline constexpr auto table<sim::Motion> = std::tuple{
    Field{"pivot", &sim::Motion::pivot,
          "point that rotations are about, in the place where the body was put", places, "m"},
    Field{
        "keyframes", &sim::Motion::keyframes,
        "the body's way, in the order of the times; it rests before the first and after the last"},
    Field{"interpolation", &sim::Motion::interpolation,
          "between keys: smooth, from rest to rest, or linear, with steady speeds"},
    Field{"oscillations", &sim::Motion::oscillations, "swings to and fro, added to the keyframes"},
    Field{"spin", &sim::Motion::spin, "a steady turn; none if left out"}};

template <>
inline constexpr auto table<sim::Obstacle> = std::tuple{
    Field{"", &sim::Obstacle::shape},
    Field{"wall_viscosity", &sim::Obstacle::wall_viscosity,
          "with which this obstacle holds the liquid back; fluid.wall_viscosity if left out",
          Range{0., 1e4}, "Pa·s"},
    Field{"motion", &sim::Obstacle::motion, "how the obstacle moves; fixed if left out"}};

template <>
inline constexpr auto table<sim::Sink> = std::tuple{Field{"", &sim::Sink::shape}};

template <>
inline constexpr auto table<sim::AccelerationKey> = std::tuple{
    Field{"time", &sim::AccelerationKey::time, "time of the key", times, "s", Presence::required},
    Field{"acceleration", &sim::AccelerationKey::acceleration,
          "body acceleration at that time, linear in between", accelerations, "m/s²",
          Presence::required}};

template <>
inline constexpr auto table<sim::AirSettings> = std::tuple{
    Field{"density", &sim::AirSettings::density, "density of the air", Range{1e-6, 1e4}, "kg/m³"},
    Field{"viscosity", &sim::AirSettings::viscosity, "dynamic viscosity of the air",
          Range{1e-9, 1e3}, "Pa·s"},
    Field{"velocity", &sim::AirSettings::velocity, "wind", speeds, "m/s"}};

template <>
inline constexpr auto table<sim::ForceSettings> = std::tuple{
    Field{"gravity", &sim::ForceSettings::gravity, "gravity", accelerations, "m/s²"},
    Field{"body", &sim::ForceSettings::body,
          "acceleration that varies in time, added to gravity, by keys in the order of their "
          "times"},
    Field{"air", &sim::ForceSettings::air,
          "air whose drag slows down spray and the liquid's surface; {} is still air at 20 °C; "
          "none if left out"}};

template <>
inline constexpr auto table<sim::SolverSettings> = std::tuple{
    Field{"type", &sim::SolverSettings::type,
          "pcisph: predictive-corrective incompressible SPH; sph: basic SPH with an equation of "
          "state"},
    Field{"backend", &sim::SolverSettings::backend,
          "what computes: the processor (cpu), a GPU (cuda), or a GPU where there is one that can "
          "(auto)"},
    Field{"pressure_kernel", &sim::SolverSettings::pressure_kernel,
          "kernel of the pressure gradient"},
    Field{"max_compression", &sim::SolverSettings::max_compression,
          "largest relative compression that a step may leave over (pcisph)", Range{1e-4, 0.5}},
    Field{"mean_compression", &sim::SolverSettings::mean_compression,
          "mean relative compression that a step may leave over (pcisph)", Range{1e-5, 0.5}},
    Field{"min_iterations", &sim::SolverSettings::min_iterations,
          "pressure iterations per step, at least, where any pressure acts (pcisph)",
          Range{1, 1000}},
    Field{"max_iterations", &sim::SolverSettings::max_iterations,
          "pressure iterations per step, at most; a step not converged by then is repeated smaller "
          "(pcisph)",
          Range{1, 10000}},
    Field{"speed_of_sound", &sim::SolverSettings::speed_of_sound,
          "of the equation of state; 0: ten times the fastest speed the scene can reach (sph)",
          Range{0., 1e5}, "m/s"},
    Field{"cfl", &sim::SolverSettings::cfl,
          "largest part of the support radius that a particle may cross in a step",
          Range{0.01, 1.}},
    Field{"max_time_step", &sim::SolverSettings::max_time_step, "longest step", Range{1e-9, 10.},
          "s"},
    Field{"min_time_step", &sim::SolverSettings::min_time_step,
          "a step that would have to be shorter ends the run", Range{1e-12, 10.}, "s"}};

template <>
inline constexpr auto table<sim::Settings> = std::tuple{
    Field{"fluid", &sim::Settings::fluid, "the liquid and where it starts"},
    Field{"domain", &sim::Settings::domain,
          "the box that holds the liquid, closed but for its open faces"},
    Field{"obstacles", &sim::Settings::obstacles, "solid bodies, fixed or moving on a script"},
    Field{"sinks", &sim::Settings::sinks, "bodies that take away what comes into them"},
    Field{"forces", &sim::Settings::forces, "what moves the liquid"},
    Field{"solver", &sim::Settings::solver, "how the motion is computed"}};

template <>
inline constexpr auto table<surface::SurfaceSettings> = std::tuple{
    Field{"cell_size", &surface::SurfaceSettings::cell_size,
          "edge of a marching-cubes cell; larger ones would miss liquid", Range{0.1, 1.},
          "particle spacings"},
    Field{"kernel_radius", &surface::SurfaceSettings::kernel_radius,
          "reach of a particle in the field", Range{1.5, 4.}, "particle spacings"},
    Field{"iso_value", &surface::SurfaceSettings::iso_value,
          "value of the field at the surface; 1 deep in the liquid, 0 outside", Range{0.2, 0.8}},
    Field{"smoothing", &surface::SurfaceSettings::smoothing,
          "iterations that take single particles' bumps off, as far as every drop and every other "
          "piece of liquid keeps 99 % of its volume",
          Range{0, 100}}};

template <>
inline constexpr auto table<CameraKey> = std::tuple{
    Field{"time", &CameraKey::time, "time of the key", times, "s"},
    Field{"position", &CameraKey::position, "where the camera is", places, "m", Presence::required},
    Field{"target", &CameraKey::target, "the point in the picture's centre", places, "m",
          Presence::required},
    Field{"up", &CameraKey::up, "the way that is up in the picture", directions},
    Field{"vertical_fov", &CameraKey::vertical_fov, "angle from the picture's lower to upper edge",
          Range{5., 120.}, "degrees"}};

template <>
inline constexpr std::string_view lone_entry_name<CameraSettings> = "a still camera";
template <>
inline constexpr auto table<CameraSettings> = std::tuple{
    Field{"keyframes", &CameraSettings::keyframes,
          "the camera's way, in the order of the times; empty: the whole domain is shown"}};

template <>
inline constexpr auto table<gl::LightSettings> = std::tuple{
    Field{"direction", &gl::LightSettings::direction, "the way the light travels", directions},
    Field{"color", &gl::LightSettings::color, "linear RGB", colors},
    Field{"intensity", &gl::LightSettings::intensity, "relative brightness", Range{0., 100.}},
    Field{"ambient", &gl::LightSettings::ambient, "sky fill, relative to the light",
          Range{0., 10.}},
    Field{"shadows", &gl::LightSettings::shadows, "whether the light casts shadows"}};

template <>
inline constexpr auto table<gl::LookSettings> = std::tuple{
    Field{"style", &gl::LookSettings::style, "the liquid as a surface or as lit spheres"},
    Field{"liquid_color", &gl::LookSettings::liquid_color, "sRGB", colors},
    Field{"shininess", &gl::LookSettings::shininess, "Phong exponent", Range{1., 2000.}},
    Field{"specular", &gl::LookSettings::specular, "strength of the highlight", Range{0., 1.}},
    Field{"background_top", &gl::LookSettings::background_top, "sRGB", colors},
    Field{"background_bottom", &gl::LookSettings::background_bottom, "sRGB", colors},
    Field{"floor_color", &gl::LookSettings::floor_color, "sRGB", colors},
    Field{"floor", &gl::LookSettings::floor, "whether the floor is drawn"},
    Field{"walls", &gl::LookSettings::walls, "whether the domain's edges are drawn"},
    Field{"obstacle_color", &gl::LookSettings::obstacle_color, "sRGB", colors},
    Field{"color_by", &gl::LookSettings::color_by, "what colours the particles"},
    Field{"color_min", &gl::LookSettings::color_min, "value at the colour map's low end",
          Range{-1e9, 1e9}, "m/s, kg/m³ or Pa"},
    Field{"color_max", &gl::LookSettings::color_max,
          "value at the high end; equal to color_min: taken from the data", Range{-1e9, 1e9},
          "m/s, kg/m³ or Pa"},
    Field{"particle_radius", &gl::LookSettings::particle_radius, "radius of a drawn particle",
          Range{0.01, 10.}, "particle spacings"}};

template <>
inline constexpr auto table<sim::SurfaceHeightProbe> = std::tuple{
    Field{"x", &sim::SurfaceHeightProbe::x, "of the vertical", places, "m", Presence::required},
    Field{"z", &sim::SurfaceHeightProbe::z, "of the vertical", places, "m", Presence::required}};

template <>
inline constexpr auto table<sim::PressureProbe> =
    std::tuple{Field{"point", &sim::PressureProbe::point,
                     "where; particles closer than two spacings are taken into account", places,
                     "m", Presence::required}};

template <>
inline constexpr auto table<sim::FrontProbe> =
    std::tuple{Field{"direction", &sim::FrontProbe::direction, "the way the front goes"}};

template <>
inline constexpr auto table<sim::EnergyProbe> = std::tuple{};

template <>
inline constexpr auto table<sim::VolumeProbe> = std::tuple{};

template <>
inline constexpr auto table<sim::Probe> =
    std::tuple{Field{"name",
                     &sim::Probe::name,
                     "names its columns: letters, digits, _ and -",
                     {},
                     {},
                     Presence::required},
               Field{"", &sim::Probe::quantity}};

template <>
inline constexpr auto table<VideoConfig> = std::tuple{
    Field{"width", &VideoConfig::width, "even", Range{16, 8192}, "pixels"},
    Field{"height", &VideoConfig::height, "even", Range{16, 8192}, "pixels"},
    Field{"frames_per_second", &VideoConfig::frames_per_second,
          "pictures per second of the liquid's time; a fraction as text, such as \"30000/1001\" "
          "(NTSC)",
          Range{1, 1000}, "1/s"},
    Field{"duration", &VideoConfig::duration, "length of the video", Range{1e-3, 1e5}, "s"},
    Field{"quality", &VideoConfig::quality,
          "H.264 constant rate factor: 0 is best, 18 looks lossless, 51 is worst; none is "
          "lossless, but the pictures in frames/ are",
          Range{0, 51}}};

template <>
inline constexpr auto table<Scene> = std::tuple{
    Field{"name", &Scene::name, "names the output folder; the file's stem if left out"},
    Field{"", &Scene::simulation},
    Field{"probes", &Scene::probes, "what is measured in the liquid, for probes.csv"},
    Field{"probes_rate", &Scene::probes_rate,
          "readings per second of the liquid's time; 0: one for every picture", Range{0., 1e6},
          "1/s"},
    Field{"surface", &Scene::surface, "how the liquid's surface is found"},
    Field{"camera", &Scene::camera, "the view: still, or by keyframes; empty: the whole domain"},
    Field{"light", &Scene::light, "one distant light and the sky"},
    Field{"look", &Scene::look, "colours and style"},
    Field{"video", &Scene::video, "size and number of the pictures"}};

}  // namespace spindrift::app
