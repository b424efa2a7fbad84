// SUMO behind sim::TrafficEngine: each road an edge of its own, all in one simulation in this process.
#include <heed/sim/traffic.h>

#include <libsumo/libsumo.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace heed::sim;

/// What SUMO keeps between calls belongs to the process.
std::atomic<bool> in_use{false};

/// SUMO reads its network and its cars from files.
class Folder {
 public:
  Folder() {
    std::string path = (std::filesystem::temp_directory_path() / "heed-drive-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) throw TrafficError("no temporary folder in " + path);
    path_ = path;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::ofstream open_for_numbers(const std::string& path) {
  std::ofstream out(path);
  out << std::setprecision(17);
  return out;
}

/// Roads lie so far apart that SUMO sees no neighbours.
constexpr double apart = 20;

void write_network(const std::string& path, const TrafficPlan& plan) {
  std::ofstream out = open_for_numbers(path);
  const double length = plan.end - plan.begin;
  out << "<net version=\"1.9\"><location netOffset=\"0,0\" convBoundary=\"0,0," << length << ','
      << plan.roads * apart << "\" origBoundary=\"0,0,1,1\" projParameter=\"!\"/>\n";
  for (std::uint32_t i = 0; i < plan.roads; ++i)
    out << "<edge id=\"e" << i << "\" from=\"a" << i << "\" to=\"b" << i << "\"><lane id=\"e" << i
        << "_0\" index=\"0\" speed=\"" << plan.speed << "\" length=\"" << length << "\" shape=\"0,"
        << i * apart << ' ' << length << ',' << i * apart << "\"/></edge>\n";
  for (std::uint32_t i = 0; i < plan.roads; ++i)
    out << "<junction id=\"a" << i << "\" type=\"dead_end\" x=\"0\" y=\"" << i * apart
        << "\" incLanes=\"\" intLanes=\"\" shape=\"0," << i * apart << "\"/>\n<junction id=\"b" << i
        << "\" type=\"dead_end\" x=\"" << length << "\" y=\"" << i * apart << "\" incLanes=\"e" << i
        << "_0\" intLanes=\"\" shape=\"" << length << ',' << i * apart << "\"/>\n";
  out << "</net>\n";
  if (!out.flush()) throw TrafficError("cannot write " + path);
}

/// A type for each car: headways differ. Other drivers expect of a driven car what they themselves would do.
void write_type(std::ofstream& out, std::size_t index, const TrafficCar& car, double expected) {
  out << "<vType id=\"t" << index << "\" length=\"" << car_length << "\" minGap=\"" << standstill_gap
      << "\" accel=\"" << car.acceleration << "\" decel=\"" << car.deceleration << "\" emergencyDecel=\""
      << car.emergency << "\" apparentDecel=\"" << (car.driven ? expected : car.deceleration) << "\" tau=\""
      << car.headway << "\" sigma=\"0\" speedFactor=\"1\" speedDev=\"0\" maxSpeed=\"200\"";
  if (car.reaction > 0) out << " actionStepLength=\"" << car.reaction << '"';
  out << "/>\n";
}

void write_cars(const std::string& path, const TrafficPlan& plan) {
  std::ofstream out = open_for_numbers(path);
  out << "<routes>\n";
  double expected = 4.5;
  for (const TrafficCar& car : plan.cars)
    if (!car.driven) expected = car.deceleration;
  for (std::size_t i = 0; i < plan.cars.size(); ++i) write_type(out, i, plan.cars[i], expected);
  for (std::uint32_t road = 0; road < plan.roads; ++road)
    out << "<route id=\"r" << road << "\" edges=\"e" << road << "\"/>\n";
  for (std::size_t i = 0; i < plan.cars.size(); ++i)
    out << "<vehicle id=\"c" << i << "\" type=\"t" << i << "\" route=\"r" << plan.cars[i].road
        << "\" depart=\"0\" departPos=\"" << plan.cars[i].position - plan.begin << "\" departSpeed=\""
        << plan.cars[i].speed << "\" insertionChecks=\"none\"/>\n";
  out << "</routes>\n";
  if (!out.flush()) throw TrafficError("cannot write " + path);
}

template <class Work>
auto translated(const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {  // SUMO's own types end at this module
    throw TrafficError(std::string("SUMO: ") + error.what());
  }
}

class Sumo final : public TrafficEngine {
 public:
  Sumo() {
    if (in_use.exchange(true)) throw TrafficError("SUMO runs once in a process, and it does already");
  }
  ~Sumo() override {
    try {
      close();
    } catch (...) {  // the process goes on without it
    }
    in_use = false;
  }

  void start(const TrafficPlan& plan) override {
    translated([&] {
      close();
      begin_ = plan.begin;
      const Folder folder;
      const std::string net = folder.file("roads.net.xml"), cars = folder.file("cars.rou.xml");
      write_network(net, plan);
      write_cars(cars, plan);
      libsumo::Simulation::load({"--net-file",
                                 net,
                                 "--route-files",
                                 cars,
                                 "--step-length",
                                 std::to_string(plan.step),
                                 "--step-method.ballistic",
                                 "true",
                                 "--collision.action",
                                 "none",
                                 "--default.speeddev",
                                 "0",
                                 "--time-to-teleport",
                                 "-1",
                                 "--xml-validation",
                                 "never",
                                 "--no-step-log",
                                 "true",
                                 "--no-warnings",
                                 "true",
                                 "--seed",
                                 "1",
                                 "--threads",
                                 "1"});
      open_ = true;
      names_.clear();
      for (std::size_t i = 0; i < plan.cars.size(); ++i) names_.push_back("c" + std::to_string(i));
      libsumo::Simulation::step();  // cars appear where they begin
      for (std::size_t i = 0; i < plan.cars.size(); ++i)
        if (plan.cars[i].driven) libsumo::Vehicle::setSpeedMode(names_[i], every_check);
    });
  }

  void advance() override {
    translated([] { libsumo::Simulation::step(); });
  }

  [[nodiscard]] CarState state(std::size_t car) override {
    return translated([&] {
      return CarState{libsumo::Vehicle::getLanePosition(names_[car]) + begin_,
                      libsumo::Vehicle::getSpeed(names_[car])};
    });
  }

  void command(std::size_t car, double speed) override {
    translated([&] { libsumo::Vehicle::setSpeed(names_[car], speed); });
  }

  [[nodiscard]] std::string version() const override { return libsumo::Simulation::getVersion().second; }

 private:
  /// All of SUMO's checks stay on, so that a car keeps its own limits; without them a speed of 0 is obeyed at
  /// 139 m/s^2.
  static constexpr int every_check = 31;

  void close() {
    if (open_) libsumo::Simulation::close();
    open_ = false;
  }

  double begin_ = 0;
  bool open_ = false;
  std::vector<std::string> names_;
};

}  // namespace

extern "C" heed::sim::TrafficEngine* heed_sumo_engine() {
  return new Sumo;
}
