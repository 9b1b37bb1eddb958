using System.Globalization;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// A vsftpd of our own. It runs as who runs the tests and asks for a password from a list,
/// which needs neither a user of the system nor its administrator:
/// logins are "anonymous" ones to vsftpd, allowed to do what a machine's login is.
/// </summary>
internal sealed class FtpPeer : IDisposable
{
    /// <summary>Has what curl's configuration, a shell, an URL and FTP could take for something else. No space: vsftpd takes one in a
    /// password of its list for an underscore.</summary>
    public const string Password = "se\"sa\\m'%41$HOME#:@/;-\\n";

    /// <summary>The time limit of a transfer, in seconds, that no transfer reaches unless something holds it,
    /// however busy the computer is.</summary>
    public const double Patience = 120;

    private readonly Daemon _daemon;

    /// <summary>Starts it.</summary>
    /// <param name="tls">Whether it speaks TLS, and how.</param>
    /// <param name="more">More lines of its configuration.</param>
    public FtpPeer(FtpTls tls, string more = "")
    {
        var home = Directory.CreateTempSubdirectory("errormatch-vsftpd-").FullName;
        Folder = Directory.CreateDirectory(Path.Combine(home, "programs")).FullName;
        Tls = tls;
        File.WriteAllText(Path.Combine(home, "passwords"), Password + "\n");
        File.WriteAllText(Path.Combine(home, "vsftpd.conf"), string.Create(CultureInfo.InvariantCulture, $"""
            background=NO
            listen=YES
            listen_address=127.0.0.1
            run_as_launching_user=YES
            seccomp_sandbox=NO
            anonymous_enable=YES
            local_enable=NO
            anon_root={home}
            anon_upload_enable=YES
            anon_other_write_enable=YES
            anon_world_readable_only=NO
            anon_umask=022
            write_enable=YES
            allow_writeable_chroot=YES
            secure_email_list_enable=YES
            email_password_file={home}/passwords
            delay_failed_login=0
            pasv_address=127.0.0.1
            pasv_min_port=20000
            pasv_max_port=30000
            max_per_ip=0
            {more}

            """) + (tls == FtpTls.None ? "" : Certificate(home)));
        _daemon = new Daemon(
            Daemon.Find("vsftpd")!,
            home,
            port => [Path.Combine(home, "vsftpd.conf"), string.Create(CultureInfo.InvariantCulture, $"-olisten_port={port}")]);
    }

    /// <summary>Where the programs are on the disk.</summary>
    public string Folder { get; }

    public int Port => _daemon.Port;

    public FtpTls Tls { get; }

    /// <summary>The public key as curl pins it; null without TLS.</summary>
    public string? PinnedKey { get; private set; }

    public static void IsNeeded() => Daemon.IsNeeded("vsftpd", "vsftpd");

    /// <summary>The machine behind it.</summary>
    public MachineSettings Machine(
        int? port = null, double seconds = Patience, int attempts = 1, string? pinned = null, string? folder = null) =>
        new()
        {
            Name = "mill",
            Transport = new FtpSettings("127.0.0.1", port ?? Port, "ftp", folder ?? Folder, Tls, pinned ?? PinnedKey),
            Dialect = "siemens-840d",
            Slots = [],
            Timeout = TimeSpan.FromSeconds(seconds),
            Attempts = attempts,
        };

    public IMachineFolder Open(int? port = null, double seconds = Patience) => MachineFolders.Open(Machine(port, seconds), () => Password);

    public void Dispose() => _daemon.Dispose();

    private string Certificate(string home)
    {
        using var key = RSA.Create(2048);
        var request = new CertificateRequest("CN=mill", key, HashAlgorithmName.SHA256, RSASignaturePadding.Pkcs1);

        // Long over, as those of machines are: only the pinned key counts.
        using var certificate = request.CreateSelfSigned(
            new DateTimeOffset(2010, 1, 1, 0, 0, 0, TimeSpan.Zero), new DateTimeOffset(2011, 1, 1, 0, 0, 0, TimeSpan.Zero));
        File.WriteAllText(
            Path.Combine(home, "certificate.pem"), certificate.ExportCertificatePem() + "\n" + key.ExportPkcs8PrivateKeyPem() + "\n");
        PinnedKey = "sha256//" + Convert.ToBase64String(SHA256.HashData(certificate.PublicKey.ExportSubjectPublicKeyInfo()));
        return $"""
            ssl_enable=YES
            allow_anon_ssl=YES
            force_anon_logins_ssl=YES
            force_anon_data_ssl=YES
            rsa_cert_file={home}/certificate.pem
            rsa_private_key_file={home}/certificate.pem
            implicit_ssl={(Tls == FtpTls.Implicit ? "YES" : "NO")}

            """;
    }
}
