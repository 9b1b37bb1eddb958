namespace ErrorMatching.Hmi.Tests;

/// <summary>A job with points that stay outside: the part must be 0.01 to 0.05 mm further out along L1, so the pair needs a gap there.
/// Compensation closes every gap. It leaves point 1 (0.117 mm before) outside, and drives out point 2 (0.027 mm before).</summary>
internal static class WantedGap
{
    private const string Limits = "\"toleranceMm\": [-0.05, 0.05]";

    /// <summary>The key points of L1, which stay outside.</summary>
    public static IReadOnlyList<string> Outside { get; } = ["1", "2"];

    /// <summary>Changes the job of a cell that is not open yet.</summary>
    /// <param name="folder">The cell's folder.</param>
    public static void In(string folder)
    {
        var file = Path.Combine(folder, "complex-mating", "job.json");
        var job = File.ReadAllText(file);
        var line = job.IndexOf("\"name\": \"L1\"", StringComparison.Ordinal);
        var limits = job.IndexOf(Limits, line, StringComparison.Ordinal);
        File.WriteAllText(file, job[..limits] + "\"toleranceMm\": [0.01, 0.05]" + job[(limits + Limits.Length)..]);
    }
}
