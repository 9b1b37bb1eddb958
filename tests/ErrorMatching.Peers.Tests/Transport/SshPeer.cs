using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>An sshd of our own with SFTP. It lets in who runs the tests, by a key made for it,
/// and by a password where the tests may give PAM a service of their own.</summary>
internal sealed class SshPeer : IDisposable
{
    public const string Password = " se\"sa\\m 'für' %41$HOME`id` ";

    private readonly Daemon _daemon;
    private readonly string? _service;
    private readonly string _home;

    /// <summary>Starts it.</summary>
    /// <param name="passwords">True if it asks PAM for passwords; the system's administrator alone can have that.</param>
    /// <param name="options">Options of its SFTP server.</param>
    public SshPeer(bool passwords = false, string options = "")
    {
        _home = Directory.CreateTempSubdirectory("errormatch-sshd-").FullName;
        Folder = Directory.CreateDirectory(On("programs of the mill")).FullName;
        MakeKey("host");
        MakeKey("user");
        MakeKey("stranger");
        HostKey = KeyOf("host");
        File.Copy(On("user.pub"), On("authorized"));
        var program = Daemon.Find("sshd")!;
        if (passwords && !OperatingSystem.IsWindows())
            (program, _service) = Passwords(program);
        if (Environment.IsPrivilegedProcess)
            Directory.CreateDirectory("/run/sshd");
        File.WriteAllText(On("sshd.conf"), string.Create(CultureInfo.InvariantCulture, $"""
            ListenAddress 127.0.0.1
            HostKey {On("host")}
            AuthorizedKeysFile {On("authorized")}
            StrictModes no
            PermitRootLogin yes
            UsePAM {(passwords ? "yes" : "no")}
            PasswordAuthentication {(passwords ? "yes" : "no")}
            KbdInteractiveAuthentication no
            KexAlgorithms curve25519-sha256
            MaxStartups 1000
            PidFile none
            Subsystem sftp internal-sftp {options}

            """));
        // -r: a session is a copy of the server instead of the program started anew, which costs a third of a login on this side.
        _daemon = new Daemon(
            program, _home, port => ["-D", "-e", "-r", "-f", On("sshd.conf"), "-p", port.ToString(CultureInfo.InvariantCulture)]);
    }

    public string Folder { get; }

    public int Port => _daemon.Port;

    /// <summary>The server's key as in <c>known_hosts</c>.</summary>
    public string HostKey { get; }

    /// <summary>A key that is not the server's.</summary>
    public string OtherKey => KeyOf("stranger");

    /// <summary>The key's file that the server lets in.</summary>
    public string KeyFile => On("user");

    /// <summary>A key's file that it does not let in.</summary>
    public string StrangersKeyFile => On("stranger");

    public static void IsNeeded()
    {
        Daemon.IsNeeded("sshd", "openssh-server");
        Daemon.IsNeeded("sftp", "openssh-client");
    }

    /// <summary>The machine behind it; the settings' key file null for a password.</summary>
    public MachineSettings Machine(Func<SftpSettings, SftpSettings>? with = null, double seconds = FtpPeer.Patience, int attempts = 1)
    {
        var settings = new SftpSettings("127.0.0.1", Port, Environment.UserName, Folder, HostKey, KeyFile);
        return new MachineSettings
        {
            Name = "mill",
            Transport = with is null ? settings : with(settings),
            Dialect = "siemens-840d",
            Slots = [],
            Timeout = TimeSpan.FromSeconds(seconds),
            Attempts = attempts,
        };
    }

    public IMachineFolder Open(Func<SftpSettings, SftpSettings>? with = null, double seconds = FtpPeer.Patience) =>
        MachineFolders.Open(Machine(with, seconds), () => Password);

    public void Dispose()
    {
        _daemon.Dispose();
        if (_service is not null)
            File.Delete(_service);
    }

    // PAM's service is called as the program is. Its script compares what was given with the password.
    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    private (string Program, string Service) Passwords(string sshd)
    {
        var name = Path.GetFileName(_home).ToLowerInvariant();
        var link = On(name);
        File.CreateSymbolicLink(link, sshd);
        File.WriteAllText(On("password"), Password);
        File.WriteAllText(On("check"), $"#!/bin/sh\nIFS= read -r given\n[ \"$given\" = \"$(cat '{On("password")}')\" ]\n");
        File.SetUnixFileMode(On("check"), UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        var service = Path.Combine("/etc/pam.d", name);
        File.WriteAllText(
            service,
            $"auth required pam_exec.so expose_authtok quiet {On("check")}\naccount required pam_permit.so\nsession required "
                + $"pam_permit.so\n");
        return (link, service);
    }

    private void MakeKey(string name)
    {
        using var made = Process.Start("ssh-keygen", ["-q", "-t", "ed25519", "-N", "", "-C", name, "-f", On(name)]);
        made.WaitForExit();
        Assert.Equal(0, made.ExitCode);
    }

    private string KeyOf(string name) => string.Join(' ', File.ReadAllText(On(name + ".pub")).Split(' ')[..2]);

    private string On(string name) => Path.Combine(_home, name);
}
