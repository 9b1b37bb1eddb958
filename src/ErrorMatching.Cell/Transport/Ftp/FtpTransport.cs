using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A folder on an FTP server, plain or with TLS, accessed with <c>curl</c>: one run and one login per operation, but two for
/// writing and reading back.</summary>
internal sealed class FtpTransport(string machine, FtpSettings ftp, Func<string?> secret, TimeSpan limit) : IMachineFolder
{
    private const int MostListed = 4 << 20;

    public string Machine => machine;

    public async Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation)
    {
        var doing = $"listing {ftp.Folder}";
        var result = await RunAsync(doing, List(Begin(doing)), MostListed, cancellation).ConfigureAwait(false);
        var answer = new CurlAnswer(result);

        // Some servers reply 550 for an empty folder, others for a missing one. The long listing distinguishes them: for an existing folder
        // it succeeds even without files.
        if (answer.IsAbsent)
        {
            var longer = await RunAsync(doing, Begin(doing).Set("url", FolderUrl()), MostListed, cancellation).ConfigureAwait(false);
            Demand(doing, new CurlAnswer(longer));
            if (!Encoding.UTF8.GetString(longer.Output).Split('\n').Any(l => l.StartsWith('-')))
                return [];
        }

        Demand(doing, answer);
        return [.. Encoding.UTF8.GetString(result.Output).Split('\n').Select(NameOf).Where(n => n is not ("" or "." or ".."))];
    }

    public async Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation)
    {
        var doing = $"reading {name}";
        var result = await RunAsync(doing, Begin(doing).Set("url", Url(doing, name)), mostBytes, cancellation).ConfigureAwait(false);
        var answer = new CurlAnswer(result);

        // 550 is the reply for a missing file and for one that must not be read.
        if (answer.IsAbsent && !(await ListAsync(cancellation).ConfigureAwait(false)).Contains(name, StringComparer.Ordinal))
            return null;
        Demand(doing, answer);
        return result.Output;
    }

    public async Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var doing = $"writing {name}";
        using var local = new PrivateFolder();
        var file = local["program"];
        await File.WriteAllBytesAsync(file, bytes, cancellation).ConfigureAwait(false);
        var url = Url(doing, name);
        var config = Begin(doing).Set("upload-file", file).Set("url", url);
        Demand(doing, new CurlAnswer(await RunAsync(doing, config, 0, cancellation).ConfigureAwait(false)));

        // A separate run: curl 7.88 sleeps for a second in 1% to 15% of runs if it reads over the connection that it wrote over.
        var result = await RunAsync(doing, Begin(doing).Set("url", url), bytes.Length + 1L, cancellation).ConfigureAwait(false);
        if (result.End != ToolEnd.TooMuch)
            Demand(doing, new CurlAnswer(result));
        return result.Output;
    }

    public async Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        var doing = $"renaming {from} to {to}";
        _ = Url(doing, from);
        var config = Begin(doing).Set("quote", "+RNFR " + from).Set("quote", "+RNTO " + to).Set("url", Url(doing, to));
        var result = await RunAsync(doing, config, mostBytes, cancellation).ConfigureAwait(false);
        var answer = new CurlAnswer(result);
        if (answer.IsRefusedCommand)
        {
            // The code alone does not tell whether an existing file was the reason.
            var names = await ListAsync(cancellation).ConfigureAwait(false);
            if (names.Contains(from, StringComparer.Ordinal) && names.Contains(to, StringComparer.Ordinal))
                throw TransportFailure.Of(TransportError.CannotReplace, machine, doing, answer.Text);
        }

        Demand(doing, answer);
        return result.Output;
    }

    // The protocol has no command for it.
    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation) =>
        Task.FromResult<ReplacedProgram?>(null);

    public async Task DeleteAsync(string name, CancellationToken cancellation)
    {
        var doing = $"deleting {name}";
        _ = Url(doing, name);

        // The dash: after the listing, which is requested only because curl does nothing without a transfer.
        var result = await RunAsync(
            doing, List(Begin(doing).Set("quote", "-DELE " + name)), MostListed, cancellation).ConfigureAwait(false);
        var answer = new CurlAnswer(result);
        if (answer.IsRefusedCommand && !(await ListAsync(cancellation).ConfigureAwait(false)).Contains(name, StringComparer.Ordinal))
            return;
        if (answer.IsAbsent)
            _ = await ListAsync(cancellation).ConfigureAwait(false);
        else
            Demand(doing, answer);
    }

    private async Task<ToolResult> RunAsync(string doing, CurlConfig config, long mostBytes, CancellationToken cancellation)
    {
        // -q: no user configuration. Everything else, secrets above all, goes through standard input.
        var run = new ToolRun("curl", ["-q", "-K", "-"], config.ToBytes(), limit) { MostOutput = mostBytes };
        var result = await ToolProcess.RunAsync(run, cancellation).ConfigureAwait(false);
        return result.End switch
        {
            ToolEnd.Missing =>
                throw TransportFailure.Of(TransportError.ToolMissing, machine, doing, "the program curl is not on this computer"),
            ToolEnd.TimedOut =>
                throw TransportFailure.Of(TransportError.Slow, machine, doing, $"it was not done within {limit.TotalSeconds:0.#} s"),
            _ => result,
        };
    }

    private void Demand(string doing, CurlAnswer answer)
    {
        if (answer.Error is { } error)
            throw TransportFailure.Of(error, machine, doing, answer.Text);
    }

    private CurlConfig Begin(string doing)
    {
        var password = secret() ?? "";
        if (ftp.User.Any(c => c == ':' || char.IsControl(c)))
            throw TransportFailure.Of(
                TransportError.Login, machine, doing, "a user's name with a colon or a control character cannot log in by FTP");
        if (password.Any(c => c is '\r' or '\n' or '\0'))
            throw TransportFailure.Of(TransportError.Login, machine, doing, "a password with a line break cannot be sent by FTP");

        var seconds = limit.TotalSeconds.ToString("0.###", CultureInfo.InvariantCulture);
        var config = new CurlConfig().Set("silent").Set("show-error").Set("globoff").Set("path-as-is").Set("ftp-skip-pasv-ip")
            .Set("ftp-method", "singlecwd")
            .Set("proto", "=ftp,ftps")
            .Set("noproxy", "*")
            .Set("connect-timeout", seconds)
            .Set("max-time", seconds)
            .Set("write-out", CurlAnswer.WriteOut)
            .Set("user", ftp.User + ":" + password);
        if (ftp.Tls == FtpTls.None)
            return config;

        // Only the pinned key decides: machines sign their own certificates, often with a wrong host name or date.
        if (ftp.PinnedKey is null)
            throw TransportFailure.Of(TransportError.WrongServer, machine, doing, "no key is pinned, so no server is trusted");

        // With TLS 1.3, servers that require the control connection's session for data (such as vsftpd) sometimes refuse curl's transfers
        // or end them early; 1.2 resumes reliably.
        return config.Set("ssl-reqd").Set("insecure").Set("pinnedpubkey", ftp.PinnedKey).Set("tls-max", "1.2");
    }

    private CurlConfig List(CurlConfig config) => config.Set("list-only").Set("url", FolderUrl());

    private string Url(string doing, string name) => ProgramNames.IsPlain(name)
        ? FolderUrl() + Uri.EscapeDataString(name)
        : throw TransportFailure.Of(TransportError.Denied, machine, doing, "this is no plain file name");

    private string FolderUrl()
    {
        var scheme = ftp.Tls == FtpTls.Implicit ? "ftps" : "ftp";
        var host = ftp.Host.Contains(':', StringComparison.Ordinal) ? $"[{ftp.Host}]" : ftp.Host;
        var folder = ftp.Folder.TrimEnd('/');
        if (folder.Length == 0 && ftp.Folder.Length > 0)
            folder = "/";

        // An absolute folder starts with an escaped slash: an unescaped one only ends the host name.
        var path = string.Join('/', folder.TrimStart('/').Split('/').Select(Uri.EscapeDataString));
        var root = folder.StartsWith('/') ? "%2F" : "";
        return string.Create(
            CultureInfo.InvariantCulture, $"{scheme}://{host}:{ftp.Port}/{root}{path}{(path.Length > 0 || root.Length > 0 ? "/" : "")}");
    }

    // Some servers include the folder in the reply.
    private static string NameOf(string line) => line.TrimEnd('\r').Split('/', '\\')[^1];
}
