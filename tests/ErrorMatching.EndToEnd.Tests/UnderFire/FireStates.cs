namespace ErrorMatching.EndToEnd.Tests;

/// <summary>How far a cell has come, asked at the console.</summary>
internal static class FireStates
{
    /// <summary>The state of the correction that a file became; null if there is none, or no store yet.</summary>
    public static async Task<string?> StateOf(this FireCell cell, string fileName)
    {
        var run = await ConsoleRun.Of(cell.Folder, "cell", "history", cell.Configuration, "--most", "1000", "--json");
        return run.Exit == 0
            ? run.Json.GetProperty("corrections")
                .EnumerateArray()
                .Where(c => c.GetProperty("fileName").GetString() == fileName)
                .Select(c => c.GetProperty("state").GetString())
                .SingleOrDefault()
            : null;
    }

    /// <summary>What <c>cell status</c> ends with, whether it says that the cell runs, and the codes of what needs help.</summary>
    public static async Task<(int Exit, bool IsRunning, string[] Codes)> Status(this FireCell cell)
    {
        var run = await ConsoleRun.Of(cell.Folder, "cell", "status", cell.Configuration, "--json");
        return run.Json.TryGetProperty("problems", out var problems)
            ? (
                run.Exit,
                run.Json.GetProperty("running").GetBoolean(),
                [.. problems.EnumerateArray().Select(p => p.GetProperty("code").GetString()!)])
            : (run.Exit, false, [.. run.Json.GetProperty("errors").EnumerateArray().Select(p => p.GetProperty("code").GetString()!)]);
    }
}
