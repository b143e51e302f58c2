// The program as a person runs it: a process with arguments, a folder of its own, and what it left behind.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <QFloat16>
#include <QProcess>
#include <QTemporaryDir>
#include <sstream>

namespace test {

using nlohmann::json;

struct Outcome {
    int code = -1; ///< -1: it crashed or never ended
    std::string out, err;
};

/// Waits for a process that was started; one that has not ended after `ms` milliseconds counts as crashed, and its
/// destructor ends it.
inline Outcome outcomeOf(QProcess& process, int ms) {
    Outcome out;
    if (process.waitForFinished(ms) && process.exitStatus() == QProcess::NormalExit)
        out.code = process.exitCode();
    out.out = process.readAllStandardOutput().toStdString();
    out.err = process.readAllStandardError().toStdString();
    return out;
}

class Program {
  public:
    std::string path(const std::string& name) const { return m_dir.filePath(name.c_str()).toStdString(); }
    QDir dir() const { return QDir(m_dir.path()); }

    /// Sets up a process that works in the folder and keeps its state there; not started.
    void prepare(QProcess& process, const QStringList& arguments) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_STATE_HOME", m_dir.filePath("state"));
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(m_dir.path());
        process.setProgram(qEnvironmentVariable("POINTCLAY_PROGRAM"));
        process.setArguments(arguments);
    }
    /// The same for the window: without a display, and with settings of its own.
    void prepareWindow(QProcess& process, const QStringList& arguments) const {
        prepare(process, arguments);
        QProcessEnvironment environment = process.processEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("HOME", m_dir.path());
        environment.insert("XDG_CONFIG_HOME", m_dir.path());
        process.setProcessEnvironment(environment);
    }
    Outcome run(const QStringList& arguments) const {
        QProcess process;
        prepare(process, arguments);
        process.start();
        return outcomeOf(process, 300000);
    }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(path(name), std::ios::binary) << content;
    }
    std::string read(const std::string& name) const {
        std::ifstream in(path(name), std::ios::binary);
        std::ostringstream out;
        out << in.rdbuf();
        return out.str();
    }
    /// Content hash of a model as `info` tells it.
    std::string hash(const std::string& model) const {
        const Outcome info = run({"info", model.c_str(), "--json"});
        return info.code == 0 ? json::parse(info.out).at("hash").get<std::string>() : "no hash: " + info.err;
    }

  private:
    QTemporaryDir m_dir;
};

/// Rows of a CSV file as text fields; the first is the header.
inline std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> out;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        out.emplace_back();
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');)
            out.back().push_back(field);
    }
    return out;
}

} // namespace test
