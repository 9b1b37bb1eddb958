using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A folder on an SFTP server, accessed with OpenSSH's <c>sftp</c>: one run and one login per operation.</summary>
internal sealed class SftpTransport(string machine, SftpSettings sftp, Func<string?> secret, TimeSpan limit) : IMachineFolder
{
    // The host key is stored under a name of our own, so that address and port do not matter.
    private const string HostAlias = "errormatch-machine";

    public string Machine => machine;

    public async Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation)
    {
        using var local = new PrivateFolder();
        var doing = $"listing {sftp.Folder}";
        var result = await RunAsync(doing, local, ["ls -1"], null, cancellation).ConfigureAwait(false);
        Demand(doing, result);
        return NamesOf(result);
    }

    public async Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation)
    {
        using var local = new PrivateFolder();
        var doing = $"reading {name}";
        var file = local["fetched"];
        var result = await RunAsync(
            doing, local, [$"get {Name(doing, name)} {Quoted(file)}"], () => IsLarger(file, mostBytes), cancellation).ConfigureAwait(false);
        if (result is { End: ToolEnd.Exited, ExitCode: 1 }
            && !(await ListAsync(cancellation).ConfigureAwait(false)).Contains(name, StringComparer.Ordinal))
            return null;
        Demand(doing, result);
        return await FetchedAsync(doing, file, mostBytes, cancellation).ConfigureAwait(false);
    }

    public async Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        using var local = new PrivateFolder();
        var doing = $"writing {name}";
        var (sent, fetched) = (local["program"], local["fetched"]);
        await File.WriteAllBytesAsync(sent, bytes, cancellation).ConfigureAwait(false);

        // The file's mode is sent along; the server's umask removes permissions that its users must not have.
        if (!OperatingSystem.IsWindows())
            File.SetUnixFileMode(sent, (UnixFileMode)0b110_110_110);
        string[] batch = [$"put -f {Quoted(sent)} {Name(doing, name)}", $"get {Name(doing, name)} {Quoted(fetched)}"];
        var result = await RunAsync(doing, local, batch, () => IsLarger(fetched, bytes.Length), cancellation).ConfigureAwait(false);
        Demand(doing, result);
        return await File.ReadAllBytesAsync(fetched, cancellation).ConfigureAwait(false);
    }

    public async Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        using var local = new PrivateFolder();
        var doing = $"renaming {from} to {to}";
        var file = local["fetched"];
        string[] batch = [$"rename {Name(doing, from)} {Name(doing, to)}", $"get {Name(doing, to)} {Quoted(file)}"];
        var result = await RunAsync(doing, local, batch, () => IsLarger(file, mostBytes), cancellation).ConfigureAwait(false);
        if (SftpAnswer.FailedAt(result, "rename"))
        {
            // The reply does not tell whether an existing file was the reason.
            var names = await ListAsync(cancellation).ConfigureAwait(false);
            if (names.Contains(from, StringComparer.Ordinal) && names.Contains(to, StringComparer.Ordinal))
                throw TransportFailure.Of(TransportError.CannotReplace, machine, doing, SftpAnswer.Text(result));
        }

        Demand(doing, result);
        return await FetchedAsync(doing, file, mostBytes, cancellation).ConfigureAwait(false);
    }

    /// <summary>Gives the program a second name, then renames, in one session. What is written to the old program's file in between is
    /// found under the second name. A file that replaces it by a rename at that moment is lost, because SFTP cannot exchange two
    /// names.</summary>
    public async Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        using var local = new PrivateFolder();
        var doing = $"replacing {to}";
        var (there, was) = (local["there"], local["was"]);
        string[] batch =
        [
            $"ln {Name(doing, to)} {Name(doing, aside)}", $"rename {Name(doing, from)} {Name(doing, to)}",
            $"get {Name(doing, to)} {Quoted(there)}", $"get {Name(doing, aside)} {Quoted(was)}",
        ];
        var result = await RunAsync(doing, local, batch, () => IsLarger(there, mostBytes) || IsLarger(was, mostBytes),
            cancellation).ConfigureAwait(false);

        // There is no program, the second name is taken, or the server does not support links: nothing is changed.
        if (SftpAnswer.FailedAt(result, "ln"))
            return null;
        if (SftpAnswer.FailedAt(result, "rename"))
        {
            // It does not rename over a file. The second name belongs to the program itself.
            await DeleteAsync(aside, cancellation).ConfigureAwait(false);
            return null;
        }

        Demand(doing, result);
        return new(
            await FetchedAsync(doing, there, mostBytes, cancellation).ConfigureAwait(false),
                await FetchedAsync(doing, was, mostBytes, cancellation).ConfigureAwait(false));
    }

    public async Task DeleteAsync(string name, CancellationToken cancellation)
    {
        using var local = new PrivateFolder();
        var doing = $"deleting {name}";

        // The dash makes sftp continue after an error; the listing that follows shows whether the file is gone.
        var result = await RunAsync(doing, local, ["-rm " + Name(doing, name), "ls -1"], null, cancellation).ConfigureAwait(false);
        Demand(doing, result);
        if (NamesOf(result).Contains(name, StringComparer.Ordinal))
            throw TransportFailure.Of(TransportError.Denied, machine, doing, "the server does not delete it");
    }

    private async Task<ToolResult> RunAsync(
        string doing, PrivateFolder local, string[] commands, Func<bool>? isTooMuch, CancellationToken cancellation)
    {
        if (sftp.Folder.Any(char.IsControl) || sftp.User.StartsWith('-') || sftp.Host.StartsWith('-'))
            throw TransportFailure.Of(TransportError.Denied, machine, doing, "folder, user or host have characters that no server's have");
        var known = local["known_hosts"];
        await File.WriteAllTextAsync(known, $"{HostAlias} {sftp.HostKey}\n", cancellation).ConfigureAwait(false);
        using var password = sftp.KeyFile is null ? new SshPassword(local, secret() ?? "") : null;
        var batch = new StringBuilder();
        if (sftp.Folder.Length > 0)
            batch.Append("cd ").Append(Quoted(sftp.Folder)).Append('\n');
        batch.AppendJoin('\n', commands).Append('\n');

        var run = new ToolRun("sftp", Arguments(known), Encoding.UTF8.GetBytes(batch.ToString()), limit)
        {
            Environment = password?.Environment ?? [],
            IsTooMuch = isTooMuch,
        };
        var result = await ToolProcess.RunAsync(run, cancellation).ConfigureAwait(false);
        return result.End switch
        {
            ToolEnd.Missing =>
                throw TransportFailure.Of(
                    TransportError.ToolMissing, machine, doing, "the program sftp of OpenSSH is not on this computer"),
            ToolEnd.TimedOut =>
                throw TransportFailure.Of(TransportError.Slow, machine, doing, $"it was not done within {limit.TotalSeconds:0.#} s"),
            ToolEnd.TooMuch => throw TransportFailure.Of(TransportError.TooLarge, machine, doing, "it is larger than what is read"),
            _ => result,
        };
    }

    // The first value of an option applies, so BatchMode precedes -b, which would forbid asking for a password.
    private List<string> Arguments(string known)
    {
        List<string> arguments = ["-F", "none"];
        void Set(string option) => arguments.AddRange(["-o", option]);
        Set("LogLevel=ERROR");
        Set("StrictHostKeyChecking=yes");
        Set("HostKeyAlias=" + HostAlias);
        Set("UserKnownHostsFile=" + ForOption(known));
        Set("GlobalKnownHostsFile=" + ForOption(known));
        Set("UpdateHostKeys=no");
        Set("CheckHostIP=no");
        Set("IdentitiesOnly=yes");
        Set("IdentityAgent=none");
        Set("ForwardAgent=no");
        Set("ControlMaster=no");
        Set("ControlPath=none");
        Set("GSSAPIAuthentication=no");
        Set(string.Create(CultureInfo.InvariantCulture, $"ConnectTimeout={Math.Max(1, (int)limit.TotalSeconds)}"));
        if (sftp.KeyFile is { } key)
        {
            Set("BatchMode=yes");
            Set("IdentityFile=" + ForOption(key));
            Set("PreferredAuthentications=publickey");
        }
        else
        {
            Set("BatchMode=no");
            Set("PubkeyAuthentication=no");
            Set("NumberOfPasswordPrompts=1");
            Set("PreferredAuthentications=password,keyboard-interactive");
        }

        var host = sftp.Host.Contains(':', StringComparison.Ordinal) ? $"[{sftp.Host}]" : sftp.Host;
        arguments.AddRange(["-o", "User=" + sftp.User, "-P", sftp.Port.ToString(CultureInfo.InvariantCulture), "-b", "-", host]);
        return arguments;
    }

    private void Demand(string doing, ToolResult result)
    {
        if (SftpAnswer.ErrorOf(result) is { } error)
            throw TransportFailure.Of(error, machine, doing, SftpAnswer.Text(result));
    }

    private async Task<byte[]> FetchedAsync(string doing, string file, long mostBytes, CancellationToken cancellation) =>
        IsLarger(file, mostBytes)
        ? throw TransportFailure.Of(TransportError.TooLarge, machine, doing, "it is larger than what is read")
        : await File.ReadAllBytesAsync(file, cancellation).ConfigureAwait(false);

    private static bool IsLarger(string file, long bytes)
    {
        var info = new FileInfo(file);
        return info.Exists && info.Length > bytes;
    }

    private string Name(string doing, string name) => ProgramNames.IsPlain(name)
        ? Quoted(name)
        : throw TransportFailure.Of(TransportError.Denied, machine, doing, "this is no plain file name");

    private static string Quoted(string path) =>
        "\"" + path.Replace("\\", "\\\\", StringComparison.Ordinal).Replace("\"", "\\\"", StringComparison.Ordinal) + "\"";

    // In options a percent sign starts a token; Windows' OpenSSH accepts slashes, which need no escapes.
    private static string ForOption(string path) =>
        "\"" + (OperatingSystem.IsWindows() ? path.Replace('\\', '/') : path).Replace("%", "%%", StringComparison.Ordinal) + "\"";

    private static string[] NamesOf(ToolResult result) =>
        [
            .. Encoding.UTF8.GetString(result.Output)
                .Split('\n')
                .Select(l => l.TrimEnd('\r'))
                .Where(l => l.Length > 0 && !l.StartsWith(SftpAnswer.Echo, StringComparison.Ordinal))];
}
