#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "support/gpu_sources.h"
#include "vulkan_shim.h"
#include "workloads.h"

// Every Vulkan call that can fail, failing: no crash, no leak, no hang, no success; and afterwards
// the same device does the same work, or says that it is lost.
namespace lobelia::test {
namespace {

host::Gpu open_gpu(bool validation = false) {
    return value_of(host::Gpu::create(
        {.validation = validation, .get_instance_proc_addr = VulkanShim::entry()}));
}

std::string text(const Fault& fault, Call call) {
    return std::string(name_of(call)) + ", call " + std::to_string(fault.call) + ", VkResult " +
           std::to_string(int(fault.code)) + (fault.sticky ? ", ever after" : ", once");
}

class OpeningFaults : public testing::Test {
protected:
    VulkanShim& shim = VulkanShim::get();
    int injected = 0;

    void TearDown() override {
        EXPECT_TRUE(shim.unknown.empty()) << "not shimmed: " << *shim.unknown.begin();
        EXPECT_EQ(shim.census.alive(), 0u) << shim.census.text();
        EXPECT_EQ(shim.census.unknown_deaths(), 0u);
        EXPECT_EQ(shim.died_in_use, 0u) << "destroyed while the device may have used it";
        RecordProperty("faults", injected);
    }
};

class DeviceFaults : public OpeningFaults, public testing::WithParamInterface<WorkloadGroup> {
protected:
    void SetUp() override { shim.pipelines.on = true; }

    /// The calls that `work` makes: the first and the last from each place in the library that was
    /// not seen before.
    std::set<std::size_t> new_calls(const std::function<void()>& work) {
        shim.faults.remember_places = true;
        shim.faults.begin();
        work();
        shim.faults.remember_places = false;
        std::map<std::size_t, std::size_t> first, last; // by place
        for (std::size_t i = 0; i < shim.faults.places().size(); ++i) {
            const std::size_t place = shim.faults.places()[i];
            if (seen_.contains(place)) continue;
            first.insert({place, i});
            last[place] = i;
        }
        std::set<std::size_t> calls;
        for (const auto& [place, call] : first) {
            calls.insert({call, last[place]});
            seen_.insert(place);
        }
        return calls;
    }

    struct Made { // a call of a workload
        std::size_t index;
        Call call;
    };
    void fail_every_way(std::optional<host::Gpu>& gpu, const Workload& work, Made made,
                        bool validation);

private:
    std::set<std::size_t> seen_; // places
};

void DeviceFaults::fail_every_way(std::optional<host::Gpu>& gpu, const Workload& work, Made made,
                                  bool validation) {
    const std::size_t alive = shim.census.alive();
    const auto [index, call] = made;
    for (const VkResult code : codes_of(call))
        for (const bool sticky : {false, true}) {
            const Fault fault{index, code, sticky};
            SCOPED_TRACE(work.name + ": " + text(fault, call));
            shim.faults.begin(fault);
            // What is refused has no result. Work that may still run is there to be waited for.
            shim.dry = call != Call::vkQueueSubmit && call != Call::vkWaitForFences;
            const auto faulty = work.run(*gpu);
            shim.dry = false;
            ASSERT_GE(shim.faults.failed(), 1u);
            shim.faults.begin();
            ++injected;
            EXPECT_FALSE(faulty) << "an error was taken for a success";
            ASSERT_EQ(shim.census.alive(), alive) << shim.census.text();
            for (const std::string& message : gpu->take_messages()) ADD_FAILURE() << message;

            const auto after = gpu->submit([](VkCommandBuffer) {});
            if (after) continue;
            EXPECT_EQ(after.error().message, "the Vulkan device is lost, open it again");
            EXPECT_TRUE(code == VK_ERROR_DEVICE_LOST ||
                        (sticky && call == Call::vkWaitForFences)); // no way to wait was left
            gpu.reset();
            ASSERT_EQ(shim.census.alive(), 0u) << shim.census.text();
            gpu = open_gpu(validation);
        }
}

TEST_P(DeviceFaults, AreReportedAndLeaveNothingBehind) {
    std::optional<host::Gpu> gpu = open_gpu();
    for (const Workload& work : GetParam().workloads) {
        const std::vector<float> expected = value_of(work.run(*gpu));
        const std::set<std::size_t> calls = new_calls([&] { value_of(work.run(*gpu)); });
        const std::vector<Call> names = shim.faults.calls();
        std::size_t done = 0;
        for (const std::size_t call : calls) {
            fail_every_way(gpu, work, {call, names[call]}, false);
            if (HasFatalFailure()) return;
            if (++done % 8 == 0 || done == calls.size()) {
                ASSERT_EQ(value_of(work.run(*gpu)), expected) << "after faults up to " << call;
            }
        }
    }
}

TEST_F(OpeningFaults, AreReportedAndLeaveNothingBehind) {
    for (const bool validation : {false, true}) {
        shim.faults.begin();
        open_gpu(validation);
        const std::vector<Call> calls = shim.faults.calls();
        for (std::size_t index = 0; index < calls.size(); ++index)
            for (const VkResult code : codes_of(calls[index])) {
                const Fault fault{index, code, false};
                SCOPED_TRACE(text(fault, calls[index]));
                shim.faults.begin(fault);
                const auto opened = host::Gpu::create(
                    {.validation = validation, .get_instance_proc_addr = VulkanShim::entry()});
                shim.faults.begin();
                ++injected;
                // Closing it has nobody to tell.
                EXPECT_EQ(bool(opened), calls[index] == Call::vkDeviceWaitIdle);
            }
    }
}

TEST_F(OpeningFaults, AFunctionThatIsNotThereIsNamed) {
    std::vector<std::string> names;
#define X(name, ...) names.push_back(#name);
    LOBELIA_SHIM_FUNCTIONS(X)
#undef X
    const WorkloadGroup& maps = workload_groups().at(2);
    std::size_t refused = 0;
    for (const std::string& name : names) {
        if (name == "vkDestroyInstance" || name == "vkDestroyDevice") continue; // nothing could
        shim.spoof.hidden = {name};
        auto gpu = host::Gpu::create({.get_instance_proc_addr = VulkanShim::entry()});
        std::string message = gpu ? "" : gpu.error().message;
        if (gpu) {
            shim.dry = true;
            const auto made = maps.workloads.front().run(*gpu);
            shim.dry = false;
            if (!made) message = made.error().message;
        }
        if (message.empty()) continue;
        ++refused;
        EXPECT_NE(message.find(name), std::string::npos) << message;
    }
    shim.spoof = {};
    EXPECT_GT(refused, 60u);
}

std::string group_name(const testing::TestParamInfo<WorkloadGroup>& info) {
    return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Of, DeviceFaults, testing::ValuesIn(workload_groups()), group_name);

} // namespace
} // namespace lobelia::test
