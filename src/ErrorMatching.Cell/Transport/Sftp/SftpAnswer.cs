using System.Text;

namespace ErrorMatching.Cell;

/// <summary>What a run of <c>sftp -b</c> came to. It says each command before it runs it and stops at the first that fails with exit code 1; 255 is the connection's.</summary>
internal static class SftpAnswer
{
    /// <summary>What stands before a command that is said.</summary>
    public const string Echo = "sftp> ";

    /// <summary>True if the last command that ran, and failed, is this one.</summary>
    public static bool FailedAt(ToolResult result, string command) =>
        result is { End: ToolEnd.Exited, ExitCode: 1 } && LastCommand(result).StartsWith(command + " ", StringComparison.Ordinal);

    /// <summary>What went wrong; null if nothing did.</summary>
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
        if (Says("Connection closed", "Connection reset", "Connection refused", "Connection lost", "Broken pipe", "Could not resolve", "No route to host", "Network is unreachable",
                "banner", "Bad packet length", "message authentication code incorrect", "Corrupted MAC", "padding error", "disconnected", "not respond"))
            return TransportError.Away;
        if (Says("not a regular file"))
            return TransportError.NotAFile;
        if (Says("subsystem request failed"))
            return TransportError.Denied;
        if (Says("Permission denied", "No such file", "not found", "Operation unsupported"))
            return TransportError.Denied;

        // The protocol's version 3 has no word for a full disk: it is a failure while writing, and hardly anything else is.
        if (FailedAt(result, "put") && Says("Failure", "No space", "quota"))
            return TransportError.Full;
        if (FailedAt(result, "rename"))
            return TransportError.Denied;
        return result.ExitCode == 255 ? TransportError.Away : TransportError.Unknown;
    }

    /// <summary>What was answered, in words.</summary>
    public static string Text(ToolResult result)
    {
        var lines = result.Error.Split('\n').Select(l => l.Trim()).Where(l => l.Length > 0 && !l.StartsWith('@')).TakeLast(3).ToArray();
        return lines.Length == 0 ? $"no reason given (sftp {result.ExitCode})" : $"{string.Join(" / ", lines)} (sftp {result.ExitCode})";
    }

    private static string LastCommand(ToolResult result)
    {
        var last = Encoding.UTF8.GetString(result.Output).Split('\n').LastOrDefault(l => l.StartsWith(Echo, StringComparison.Ordinal)) ?? "";
        return last.Length == 0 ? "" : last[Echo.Length..];
    }
}
