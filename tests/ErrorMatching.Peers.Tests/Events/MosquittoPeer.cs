using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>A broker of the tests' own: Debian's mosquitto on a loopback port, with TLS, one user, and what it holds saved every second.
/// It is killed as a power cut would, and started again at the same port.</summary>
internal sealed class MosquittoPeer : IDisposable
{
    public const string User = "cell";
    public const string Password = " pa\"ss wörd ";
    public const string Topic = "plant/steps";

    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(1);
    private readonly string _home = Directory.CreateTempSubdirectory("errormatch-mosquitto-").FullName;
    private readonly string _said;
    private readonly int _savedEveryS;
    private Process? _process;

    /// <summary>Starts a broker.</summary>
    /// <param name="savedEveryS">How often what it holds is saved.</param>
    public MosquittoPeer(int savedEveryS = 1)
    {
        _savedEveryS = savedEveryS;
        _said = On("log");
        using var authority = Authority("Plant CA");
        using var stranger = Authority("Another CA");
        File.WriteAllText(On("ca.pem"), authority.ExportCertificatePem());
        File.WriteAllText(On("stranger.pem"), stranger.ExportCertificatePem());
        PinnedKey = Issue(authority);
        File.WriteAllText(PasswordFile, Password + "\n");
        File.WriteAllText(WrongPasswordFile, "guessed\n");
        if (!OperatingSystem.IsWindows())
        {
            foreach (var file in new[] { PasswordFile, WrongPasswordFile })
            {
                File.SetUnixFileMode(file, UnixFileMode.UserRead | UnixFileMode.UserWrite);
            }
        }

        using (var made = Process.Start(Daemon.Find("mosquitto_passwd")!, ["-b", "-c", On("passwords"), User, Password]))
        {
            made.WaitForExit();
            Assert.Equal(0, made.ExitCode);
        }

        File.WriteAllText(On("acl"), $"user {User}\ntopic write {Topic}\ntopic read {Topic}\n");
        for (var tries = 0; !TryStart(Port = Daemon.AnyPort()); tries++)
        {
            Assert.True(tries < 20, "mosquitto does not start at any port: " + File.ReadAllText(_said));
        }
    }

    public int Port { get; private set; }

    public string PinnedKey { get; }

    public string PasswordFile => On("password");

    public string WrongPasswordFile => On("guess");

    public string AuthorityFile => On("ca.pem");

    public string StrangersFile => On("stranger.pem");

    /// <summary>The settings of a cell that publishes to it.</summary>
    public EventSettings Settings => new("127.0.0.1", Port, Topic, User, PasswordFile, true, AuthorityFile, null);

    public static void IsNeeded() => Daemon.IsNeeded("mosquitto", "mosquitto");

    public void Kill()
    {
        _process!.Kill();
        _process.WaitForExit();
        _process.Dispose();
        _process = null;
    }

    /// <summary>Saves what it holds now.</summary>
    public void Save()
    {
        var (saved, begun) = (On("mosquitto.db"), Stopwatch.GetTimestamp());
        var before = File.GetLastWriteTimeUtc(saved);
        using (var told = Process.Start("kill", ["-USR1", _process!.Id.ToString(CultureInfo.InvariantCulture)]))
        {
            told.WaitForExit();
            Assert.Equal(0, told.ExitCode);
        }

        while (!File.Exists(saved) || File.GetLastWriteTimeUtc(saved) == before)
        {
            Assert.True(Stopwatch.GetElapsedTime(begun) < Limit, "mosquitto does not save.");
            Thread.Sleep(20);
        }
    }

    /// <summary>Starts it again at its port; whoever held the port meanwhile gives it back soon.</summary>
    public void Start()
    {
        var begun = Stopwatch.GetTimestamp();
        while (!TryStart(Port))
        {
            Assert.True(Stopwatch.GetElapsedTime(begun) < Limit, "mosquitto does not start again: " + File.ReadAllText(_said));
            Thread.Sleep(20);
        }
    }

    public void Dispose()
    {
        if (_process is not null)
        {
            Kill();
        }

        Directory.Delete(_home, recursive: true);
    }

    private static X509Certificate2 Authority(string name)
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        var request = new CertificateRequest($"CN={name}", key, HashAlgorithmName.SHA256);
        request.CertificateExtensions.Add(new X509BasicConstraintsExtension(true, false, 0, true));
        request.CertificateExtensions.Add(new X509SubjectKeyIdentifierExtension(request.PublicKey, false));
        return request.CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow.AddDays(2));
    }

    // Its certificate and key, for 127.0.0.1 alone.
    private string Issue(X509Certificate2 authority)
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        var request = new CertificateRequest("CN=broker", key, HashAlgorithmName.SHA256);
        var names = new SubjectAlternativeNameBuilder();
        names.AddIpAddress(IPAddress.Loopback);
        request.CertificateExtensions.Add(names.Build());
        using var made = request.Create(authority, DateTimeOffset.UtcNow.AddHours(-1), DateTimeOffset.UtcNow.AddDays(1), [1, 2, 3]);
        File.WriteAllText(On("broker.pem"), made.ExportCertificatePem());
        File.WriteAllText(On("broker.key"), key.ExportPkcs8PrivateKeyPem());
        return "sha256//" + Convert.ToBase64String(SHA256.HashData(made.PublicKey.ExportSubjectPublicKeyInfo()));
    }

    private bool TryStart(int port)
    {
        File.WriteAllText(On("mosquitto.conf"), string.Create(CultureInfo.InvariantCulture, $"""
            user root
            listener {port} 127.0.0.1
            allow_anonymous false
            password_file {On("passwords")}
            acl_file {On("acl")}
            cafile {On("ca.pem")}
            certfile {On("broker.pem")}
            keyfile {On("broker.key")}
            persistence true
            persistence_location {_home}/
            autosave_interval {_savedEveryS}
            max_queued_messages 0
            log_dest file {_said}

            """));
        var process = Process.Start(new ProcessStartInfo(Daemon.Find("mosquitto")!, ["-c", On("mosquitto.conf")])
        {
            UseShellExecute = false
        })!;
        var since = Stopwatch.GetTimestamp();
        while (!ProcessTable.Listens(process.Id, port))
        {
            if (process.HasExited || Stopwatch.GetElapsedTime(since) > Limit)
            {
                process.Dispose();
                return false;
            }

            Thread.Sleep(5);
        }

        _process = process;
        return true;
    }

    private string On(string name) => Path.Combine(_home, name);
}
