using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;
using Npgsql;

namespace ErrorMatching.Peers.Tests;

/// <summary>A real PostgreSQL server of the tests' own, from Debian's package postgresql-15: a fresh cluster in a temporary folder on a
/// free loopback port, with passwords.</summary>
public sealed class PostgresServer : IDisposable
{
    private const string Package = "postgresql-15";
    private const string Password = "only for tests";
    private const string User = "errormatch";
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(3);
    private static readonly string? Programs = FindPrograms();
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-postgres-").FullName;
    private Process? _server;
    private int _databases;

    public PostgresServer()
    {
        if (Programs is null || !OperatingSystem.IsLinux()) return;
        File.WriteAllText(Path.Combine(_folder, "password"), Password);
        PasswordFile = Path.Combine(_folder, "pgpass");
        File.WriteAllText(PasswordFile, $"127.0.0.1:*:*:{User}:{Password}\n");
        SetMode(PasswordFile, "600");
        if (Environment.UserName == "root") Run("chown", "-R", "postgres", _folder);
        Run(AsServer(
            Path.Combine(Programs, "initdb"),
            "-D",
            Data,
            "-U",
            User,
            "--auth=scram-sha-256",
            $"--pwfile={Path.Combine(_folder, "password")}",
            "--encoding=UTF8",
            "--no-locale",
            "--no-sync"));


        // Another program may have the port.
        for (var tries = 0; !TryStart(Port = Daemon.AnyPort()); tries++)
            Assert.True(tries < 20, "PostgreSQL does not start at any port.");
    }

    /// <summary>Takes each line of the server's log.</summary>
    public Action<string>? Said { get; set; }

    private int Port { get; set; }

    private string PasswordFile { get; } = "";

    private string Data => Path.Combine(_folder, "data");

    /// <summary>Skips the current test where the server is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Whose a port is, is read from /proc.");
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
        {
            Assert.True(Programs is not null, $"PostgreSQL is missing: install the package {Package}.");
        }

        Assert.SkipUnless(Programs is not null, $"PostgreSQL is not installed (package {Package}).");
    }

    /// <summary>Says who may read and write a file, as chmod does.</summary>
    public static void SetMode(string file, string mode) => Run("chmod", mode, file);

    /// <summary>Makes an empty database.</summary>
    /// <param name="how">What else CREATE DATABASE is told.</param>
    public PostgresSettings NewDatabase(string how = "")
    {
        var name = string.Create(CultureInfo.InvariantCulture, $"cell{Interlocked.Increment(ref _databases)}");
        Execute("postgres", $"CREATE DATABASE {name} {how}");
        return new PostgresSettings("127.0.0.1", Port, name, User, PasswordFile);
    }

    /// <summary>The store's part of a cell's configuration.</summary>
    /// <param name="settings">The database.</param>
    /// <param name="schema">The cell's own schema; null for none.</param>
    public string StoreOf(PostgresSettings settings, string? schema = null)
    {
        var own = schema is null ? "" : $", \"schema\": \"{schema}\"";
        return string.Create(
            CultureInfo.InvariantCulture,
            $$"""
            { "kind": "postgresql", "host": "{{settings.Host}}", "port": {{settings.Port}}, "database": "{{settings.Database}}",
              "user": "{{settings.User}}", "passwordFile": "{{settings.PasswordFile}}"{{own}} }
            """);
    }

    /// <summary>Runs a statement as the owner of the server, beside any store.</summary>
    public void Execute(string database, string sql)
    {
        using var connection = Connect(database);
        using var command = new NpgsqlCommand(sql, connection);
        command.ExecuteNonQuery();
    }

    /// <summary>The number that a statement finds.</summary>
    public long Value(string database, string sql)
    {
        using var connection = Connect(database);
        using var command = new NpgsqlCommand(sql, connection);
        return (long)command.ExecuteScalar()!;
    }

    /// <summary>Runs one of PostgreSQL's own programs with the server's address and password, and fails the test if it fails.</summary>
    public void RunProgram(string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(
            Path.Combine(Programs!, program),
            ["--host=127.0.0.1", string.Create(CultureInfo.InvariantCulture, $"--port={Port}"), $"--username={User}", .. arguments]);
        start.Environment["PGPASSFILE"] = PasswordFile;
        Run(start);
    }

    /// <summary>Starts the server again at its port and waits until it answers.</summary>
    public void Start()
    {
        // What a cut left is put in order here, without waiting for the disk:
        // alone the server would first write out every file of every database that the tests have made.
        Run(AsServer(Path.Combine(Programs!, "postgres"), "--single", "-D", Data, "-c", "fsync=off", "postgres"));

        // It refuses to as long as it takes the number of its process before, which a file tells, for that of a living one.
        var begun = Stopwatch.GetTimestamp();
        while (!TryStart(Port))
        {
            Assert.True(Stopwatch.GetElapsedTime(begun) < Limit, $"PostgreSQL does not start at port {Port} again.");
            Thread.Sleep(50);
        }
    }

    private bool TryStart(int port)
    {
        var start = AsServer(
            Path.Combine(Programs!, "postgres"),
            "-D",
            Data,
            "-p",
            port.ToString(CultureInfo.InvariantCulture),
            "-c",
            "listen_addresses=127.0.0.1",
            "-c",
            "unix_socket_directories=",
            "-c",
            "shared_buffers=16MB");
        start.UseShellExecute = false;
        start.RedirectStandardError = true;
        start.RedirectStandardOutput = true;
        _server = Process.Start(start)!;
        _server.ErrorDataReceived += (_, line) => Said?.Invoke(line.Data ?? "");
        _server.OutputDataReceived += (_, _) => { };
        _server.BeginErrorReadLine();
        _server.BeginOutputReadLine();
        var begun = Stopwatch.GetTimestamp();
        while (!_server.HasExited)
        {
            try
            {
                // Somebody else's server at this port is none of ours.
                if (ProcessTable.Listens(_server.Id, port))
                {
                    Connect("postgres").Dispose();
                    return true;
                }
            }
            catch (NpgsqlException) when (Stopwatch.GetElapsedTime(begun) < Limit)
            {
            }

            Thread.Sleep(20);
        }

        _server.Dispose();
        _server = null;
        return false;
    }

    /// <summary>Kills the server as a power cut would, with all its connections.</summary>
    public void Kill()
    {
        var all = ProcessTable.Descendants(_server!.Id).Select(p => p.Id).Append(_server.Id).ToArray();
        _server.Kill(entireProcessTree: true);
        Assert.True(_server.WaitForExit(Limit) && ProcessTable.EndAsync(all).GetAwaiter().GetResult(), "The server does not end.");
        _server.Dispose();
        _server = null;
    }

    public void Dispose()
    {
        if (_server is not null) Kill();
        Directory.Delete(_folder, recursive: true);
    }

    private NpgsqlConnection Connect(string database)
    {
        var connection = new NpgsqlConnection(new NpgsqlConnectionStringBuilder
        {
            Host = "127.0.0.1",
            Port = Port,
            Database = database,
            Username = User,
            Password = Password,
            Pooling = false,
            Timeout = (int)Limit.TotalSeconds,
            CommandTimeout = (int)Limit.TotalSeconds,
        }.ConnectionString);
        connection.Open();
        return connection;
    }

    // The server refuses to run as root.
    private static ProcessStartInfo AsServer(string program, params string[] arguments) => Environment.UserName == "root"
        ? new ProcessStartInfo("setpriv", ["--reuid=postgres", "--regid=postgres", "--clear-groups", program, .. arguments])
        {
            WorkingDirectory = "/"
        }
        : new ProcessStartInfo(program, arguments);

    private static void Run(string program, params string[] arguments) => Run(new ProcessStartInfo(program, arguments));

    private static void Run(ProcessStartInfo start)
    {
        start.UseShellExecute = false;
        start.RedirectStandardOutput = true;
        start.RedirectStandardError = true;
        start.RedirectStandardInput = true;
        using var process = Process.Start(start)!;
        process.StandardInput.Close();
        var (output, error) = (process.StandardOutput.ReadToEndAsync(), process.StandardError.ReadToEndAsync());
        if (!process.WaitForExit(Limit))
        {
            process.Kill(entireProcessTree: true);
            Assert.Fail($"{start.FileName} runs longer than {Limit}.");
        }

        Assert.True(
            process.ExitCode == 0,
            $"{start.FileName} {string.Join(' ', start.ArgumentList)}: exit "
                + $"{process.ExitCode}\n{output.GetAwaiter().GetResult()}\n{error.GetAwaiter().GetResult()}");
    }

    private static string? FindPrograms() => (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Prepend("/usr/lib/postgresql/15/bin")
        .FirstOrDefault(f => File.Exists(Path.Combine(f, "postgres")) && File.Exists(Path.Combine(f, "initdb")));
}
