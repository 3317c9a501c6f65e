#include "live_server.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "live_history.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_HTTP
#include <httplib.h>
#endif

namespace symscene::app {

bool LiveAddress::is_loopback() const {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

std::string random_token() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device());
}

#ifdef SYMSCENE_HAS_HTTP

namespace {

constexpr std::size_t threads = 16;
constexpr int max_streams = 8;  ///< each holds a thread
constexpr std::size_t default_points = 20000;
constexpr std::chrono::milliseconds keep_alive{1000};

/// In constant time: its duration does not tell how much of a guess is right.
bool is_equal(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i] ^ b[i]));
  return difference == 0;
}

/// A number of a request; none if the text is not one of at most nine digits.
std::optional<std::size_t> number_of(const std::string& text) {
  const bool is_number =
      !text.empty() && text.size() < 10 &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? std::optional<std::size_t>(std::stoul(text)) : std::nullopt;
}

std::string event_of(const LiveHistory::News& news, const std::string& run) {
  std::string text;
  if (news.newest) {
    text += fmt::format("id: {0}-{1}\ndata: {{\"run\":\"{0}\",\"oldest\":{2},\"report\":{3}}}\n\n",
                        run, news.newest->number, news.oldest, live_json(*news.newest));
  }
  if (news.is_finished) text += "event: finished\ndata: {}\n\n";
  return text.empty() ? ": waiting\n\n" : text;
}

/// What pages need of a report: of the cloud positions and colours, no hypotheses and surfaces.
std::shared_ptr<const LiveReport> for_pages(const LiveReport& report) {
  auto kept = std::make_shared<LiveReport>(report);
  SegmentationResult& result = kept->update.result;
  result.cloud.normals.resize(0, 3);
  result.rejected.clear();
  result.completed.clear();
  result.surfaces.clear();
  return kept;
}

/// A port in use is refused, that of another run of this user too.
void reuse_only_closed(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

struct LiveServer::Implementation {
  Implementation(LiveAddress given, std::string html)
      : address(std::move(given)), page(std::move(html)) {
    server.set_socket_options(reuse_only_closed);
    server.set_keep_alive_timeout(1);
    server.set_payload_max_length(1024);  // no request has a body
    server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& reply) {
          return admit(request, reply);
        });
    server.Get("/", [this](const httplib::Request&, httplib::Response& reply) {
      reply.set_content(page, "text/html; charset=utf-8");
    });
    server.Get("/events", [this](const httplib::Request& request, httplib::Response& reply) {
      stream(request, reply);
    });
    server.Get(R"(/updates/(\d+))", [this](const httplib::Request& request,
                                           httplib::Response& reply) { send(request, reply); });
    port = address.port == 0 ? server.bind_to_any_port(address.host.c_str())
           : server.bind_to_port(address.host.c_str(), address.port) ? address.port
                                                                     : -1;
    if (port < 0)
      throw InputError("--host, --port", "an address that is free on this machine",
                       fmt::format("{}:{}", address.host, address.port));
    listener = std::thread([this] {
      server.listen_after_bind();
      has_ended = true;
    });
    // A server that does not listen yet cannot be stopped.
    while (!server.is_running() && !has_ended)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  ~Implementation() {
    history.close();
    server.stop();
    listener.join();
  }

  using Routing = httplib::Server::HandlerResponse;

  Routing admit(const httplib::Request& request, httplib::Response& reply) const {
    reply.set_header("Cache-Control", "no-store");
    reply.set_header("X-Content-Type-Options", "nosniff");
    reply.set_header("Referrer-Policy", "no-referrer");
    const bool is_admitted = address.token.empty()
                                 ? is_for_this_host(request.get_header_value("Host"))
                                 : is_equal(request.get_param_value("token"), address.token);
    if (is_admitted) return Routing::Unhandled;
    reply.status = 403;
    reply.set_content(
        "The address lacks the token that symscene watch printed, or names another host.\n",
        "text/plain");
    return Routing::Handled;
  }

  bool is_for_this_host(std::string host) const {
    if (const std::size_t colon = host.rfind(':');
        colon != std::string::npos && host.find(']', colon) == std::string::npos)
      host.erase(colon);
    return host == address.host || host == "localhost" || host == "127.0.0.1" || host == "[::1]";
  }

  /// The update that a page which lost its connection got last; 0 if it was one of another run.
  std::size_t known_to(const httplib::Request& request) const {
    const std::string id = request.get_header_value("Last-Event-ID");
    const std::string own = run + "-";
    return id.starts_with(own) ? number_of(id.substr(own.size())).value_or(0) : 0;
  }

  void stream(const httplib::Request& request, httplib::Response& reply) {
    if (++streams > max_streams) {
      --streams;
      reply.status = 503;
      reply.set_content("Too many pages are open.\n", "text/plain");
      return;
    }
    reply.set_chunked_content_provider(
        "text/event-stream",
        [this, known = known_to(request), knows_end = false](std::size_t,
                                                             httplib::DataSink& sink) mutable {
          LiveHistory::News news = history.wait(known, knows_end, keep_alive);
          if (news.is_closed) return false;
          if (news.newest) known = news.newest->number;
          news.is_finished = std::exchange(knows_end, news.is_finished) != news.is_finished;
          const std::string event = event_of(news, run);
          return sink.write(event.data(), event.size());
        },
        [this](bool) { --streams; });
  }

  void send(const httplib::Request& request, httplib::Response& reply) const {
    const std::optional<std::size_t> number = number_of(request.matches[1]);
    const auto report = number ? history.find(*number) : nullptr;
    if (!report) {
      reply.status = 404;
      reply.set_content("This update is not kept.\n", "text/plain");
      return;
    }
    const std::size_t most = number_of(request.get_param_value("points")).value_or(default_points);
    reply.set_content(live_bytes(*report, most), "application/octet-stream");
  }

  LiveAddress address;
  std::string page;
  std::string run = random_token();  ///< so that pages notice a new run at the same address
  int port = -1;
  LiveHistory history;
  std::atomic<int> streams = 0;
  std::atomic<bool> has_ended = false;
  httplib::Server server;
  std::thread listener;
};

bool LiveServer::is_built() { return true; }

LiveServer::LiveServer(const LiveAddress& address, std::string page)
    : implementation_(std::make_unique<Implementation>(address, std::move(page))) {}

std::string LiveServer::url() const {
  const LiveAddress& address = implementation_->address;
  const bool is_any = address.host == "0.0.0.0" || address.host == "::";
  const std::string host = is_any ? "localhost" : address.host;
  const bool is_v6 = host.find(':') != std::string::npos;
  return fmt::format("http://{}:{}/{}", is_v6 ? "[" + host + "]" : host, implementation_->port,
                     address.token.empty() ? "" : "?token=" + address.token);
}

void LiveServer::publish(std::shared_ptr<const LiveReport> report) {
  implementation_->history.add(for_pages(*report));
}

void LiveServer::finish() { implementation_->history.finish(); }

#else

struct LiveServer::Implementation {};

bool LiveServer::is_built() { return false; }

LiveServer::LiveServer(const LiveAddress&, std::string) {
  throw InputError("symscene watch",
                   "a build with an HTTP server (libcpp-httplib-dev), or --no-server",
                   "one without");
}

std::string LiveServer::url() const { return {}; }
void LiveServer::publish(std::shared_ptr<const LiveReport>) {}
void LiveServer::finish() {}

#endif

LiveServer::~LiveServer() = default;

}  // namespace symscene::app
