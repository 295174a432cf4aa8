#include "loader.h"

#include <future>

#include "window.h"

namespace lobelia::cli {

using host::Outcome;

struct Loader::Job {
    std::promise<Outcome<host::Environment>> promise;
    std::future<Outcome<host::Environment>> result = promise.get_future();
};

namespace {

Outcome<host::Environment> read(const std::string& path) {
    try {
        return host::read_environment(path);
    } catch (const std::bad_alloc&) {
        return host::Failure{path + ": takes more memory than there is"};
    }
}

} // namespace

void Loader::begin(const std::string& path) {
    path_ = path;
    began_ = std::chrono::steady_clock::now();
    job_ = std::make_shared<Job>();
    threads_.emplace_back([job = job_, path] {
        job->promise.set_value(read(path));
        Window::wake();
    });
}

double Loader::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

std::optional<Outcome<host::Environment>> Loader::take() {
    if (!job_ || job_->result.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    auto result = job_->result.get();
    job_.reset();

    return result;
}

} // namespace lobelia::cli
