using System.Text;

namespace ErrorMatching.Cell;

/// <summary>The result of a run of <c>sftp -b</c>. It echoes each command before it runs it, and stops at the first that fails with exit
/// code 1; 255 is a connection failure.</summary>
internal static class SftpAnswer
{
    /// <summary>The prefix of an echoed command.</summary>
    public const string Echo = "sftp> ";

    /// <summary>True if this is the last command that ran, and it failed.</summary>
    public static bool FailedAt(ToolResult result, string command) =>
        result is { End: ToolEnd.Exited, ExitCode: 1 } && LastCommand(result).StartsWith(command + " ", StringComparison.Ordinal);

    /// <summary>The error; null if there is none.</summary>
    public static TransportError? ErrorOf(ToolResult result)
    {
        if (result.ExitCode == 0)
            return null;
        var said = result.Error;
        bool Says(params string[] words) => words.Any(w => said.Contains(w, StringComparison.OrdinalIgnoreCase));

        if (Says("Host key verification failed", "HOST IDENTIFICATION HAS CHANGED", "No matching host key", "key is known for"))
            return TransportError.WrongServer;
        if (Says("Permission denied (", "Too many authentication failures", "Permission denied, please try again"))
            return TransportError.Login;
        if (Says("bad permissions", "invalid format", "Load key"))
            return TransportError.Login;
        if (Says("timed out"))
            return TransportError.Slow;
        if (Says(
            "Connection closed",
            "Connection reset",
            "Connection refused",
            "Connection lost",
            "Broken pipe",
            "Could not resolve",
            "No route to host",
            "Network is unreachable",
                "banner",
                "Bad packet length",
                "message authentication code incorrect",
                "Corrupted MAC",
                "padding error",
                "disconnected",
                "not respond"))
            return TransportError.Away;
        if (Says("not a regular file"))
            return TransportError.NotAFile;
        if (Says("subsystem request failed"))
            return TransportError.Denied;
        if (Says("Permission denied", "No such file", "not found", "Operation unsupported"))
            return TransportError.Denied;

        // Version 3 of the protocol has no code for a full disk; a failure while writing is hardly ever anything else.
        if (FailedAt(result, "put") && Says("Failure", "No space", "quota"))
            return TransportError.Full;
        if (FailedAt(result, "rename"))
            return TransportError.Denied;
        return result.ExitCode == 255 ? TransportError.Away : TransportError.Unknown;
    }

    /// <summary>The error message.</summary>
    public static string Text(ToolResult result)
    {
        var lines = result.Error.Split('\n').Select(l => l.Trim()).Where(l => l.Length > 0 && !l.StartsWith('@')).TakeLast(3).ToArray();
        return lines.Length == 0 ? $"no reason given (sftp {result.ExitCode})" : $"{string.Join(" / ", lines)} (sftp {result.ExitCode})";
    }

    private static string LastCommand(ToolResult result)
    {
        var last = Encoding.UTF8.GetString(result.Output).Split('\n').LastOrDefault(l => l.StartsWith(Echo, StringComparison.Ordinal))
            ?? "";
        return last.Length == 0 ? "" : last[Echo.Length..];
    }
}
