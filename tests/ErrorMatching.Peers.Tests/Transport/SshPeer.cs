using System.Collections.Concurrent;
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
    private readonly string[] _kinds;
    private readonly ConcurrentBag<IMachineFolder> _opened = [];

    /// <summary>Starts it.</summary>
    /// <param name="passwords">True if it asks PAM for passwords; the system's administrator alone can have that.</param>
    /// <param name="options">Options of its SFTP server.</param>
    /// <param name="more">More lines of its configuration; the first of a kind counts.</param>
    /// <param name="kinds">The types of its host's keys, such as <c>rsa</c>.</param>
    public SshPeer(bool passwords = false, string options = "", string more = "", params string[] kinds)
    {
        _home = Directory.CreateTempSubdirectory("errormatch-sshd-").FullName;
        Folder = Directory.CreateDirectory(On("programs of the mill")).FullName;
        _kinds = kinds.Length == 0 ? ["ed25519"] : kinds;
        foreach (var kind in _kinds)
            MakeKey("host-" + kind, kind);
        MakeKey("user", "ed25519");
        MakeKey("stranger", "ed25519");
        File.Copy(On("user.pub"), On("authorized"));
        var program = Daemon.Find("sshd")!;
        if (passwords && !OperatingSystem.IsWindows())
            (program, _service) = Passwords(program);
        if (Environment.IsPrivilegedProcess)
            Directory.CreateDirectory("/run/sshd");
        File.WriteAllText(On("sshd.conf"), string.Create(CultureInfo.InvariantCulture, $"""
            ListenAddress 127.0.0.1
            {more}
            {string.Join('\n', _kinds.Select(k => "HostKey " + On("host-" + k)))}
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
    public string HostKey => HostKeyOf(_kinds[0]);

    /// <summary>A key that is not the server's.</summary>
    public string OtherKey => KeyOf("stranger");

    /// <summary>The key's file that the server lets in.</summary>
    public string KeyFile => On("user");

    /// <summary>A key's file that it does not let in.</summary>
    public string StrangersKeyFile => On("stranger");

    public static void IsNeeded()
    {
        Daemon.IsNeeded("sshd", "openssh-server");
        Daemon.IsNeeded("ssh-keygen", "openssh-client");
    }

    /// <summary>One of the server's keys as in <c>known_hosts</c>.</summary>
    public string HostKeyOf(string kind) => KeyOf("host-" + kind);

    /// <summary>Makes another key that the server lets in.</summary>
    /// <returns>The private key's file.</returns>
    public string Welcome(string name, string kind, string passphrase = "", params string[] form)
    {
        MakeKey(name, kind, passphrase, form);
        File.AppendAllText(On("authorized"), File.ReadAllText(On(name + ".pub")));
        return On(name);
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

    /// <summary>Opens the folder. Who does not close it has it closed with the server.</summary>
    public IMachineFolder Open(Func<SftpSettings, SftpSettings>? with = null, double seconds = FtpPeer.Patience)
    {
        var folder = MachineFolders.Open(Machine(with, seconds), () => Password);
        _opened.Add(folder);
        return folder;
    }

    public void Dispose()
    {
        foreach (var folder in _opened)
            folder.Dispose();
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
            $"auth required pam_exec.so expose_authtok quiet {On("check")}\nauth required pam_permit.so\naccount required pam_permit.so\n"
                + "session required pam_permit.so\n");
        return (link, service);
    }

    private void MakeKey(string name, string kind, string passphrase = "", params string[] form)
    {
        using var made = Process.Start("ssh-keygen", ["-q", "-t", kind, "-N", passphrase, "-C", name, "-f", On(name), .. form]);
        made.WaitForExit();
        Assert.Equal(0, made.ExitCode);
    }

    private string KeyOf(string name) => string.Join(' ', File.ReadAllText(On(name + ".pub")).Split(' ')[..2]);

    private string On(string name) => Path.Combine(_home, name);
}
