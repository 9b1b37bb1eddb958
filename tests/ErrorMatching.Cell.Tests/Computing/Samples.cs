using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>The samples as jobs of a cell.</summary>
internal static class Samples
{
    public static readonly PolicySettings NoLimits = new(Automatic: true, LimitMm: null, SumLimitMm: null, Gain: null);

    /// <summary>A job of the cell whose file is that of a sample, or another one.</summary>
    public static CellJobSettings Job(string file) => new()
    {
        Name = "sample",
        File = Path.IsPathRooted(file) ? file : Repository.PathTo("samples", file, "job.json"),
        Gauges = ["gauge"],
        Recognize = new(".*", null, null),
        Machine = "mill",
        Slot = "1",
        InOrderOfSerial = false,
        Accumulates = false,
    };

    public static StoredFile File(string sample, string name) =>
        new(name, System.IO.File.ReadAllBytes(Repository.PathTo("samples", sample, name)));

    public static CorrectionRequest Part(string sample) =>
        new() { Job = Job(sample), Piece = "part", Measurement = File(sample, "part.csv") };

    public static CorrectionRequest Surface(string sample) =>
        new() { Job = Job(sample), Piece = "surface", Measurement = File(sample, "measured.csv") };

    public static Computation Compute(CorrectionRequest request, PolicySettings? policy = null) =>
        new CorrectionComputer(policy ?? NoLimits).Compute(request, TestContext.Current.CancellationToken);

    public static ComputedProgram Program(CorrectionRequest request, PolicySettings? policy = null) => Compute(request, policy) switch
    {
        ComputedProgram computed => computed,
        RefusedComputation refused => throw new InvalidOperationException($"{refused.Code}: {refused.Reason}"),
        var other => throw new InvalidOperationException(other.ToString()),
    };

    public static RefusedComputation Refusal(CorrectionRequest request, PolicySettings? policy = null) =>
        Assert.IsType<RefusedComputation>(Compute(request, policy));

    /// <summary>A copy of the mating sample.</summary>
    public static CellJobSettings Copied(TemporaryFolder folder)
    {
        const string sample = "complex-mating";
        foreach (var file in Directory.GetFiles(Repository.PathTo("samples", sample)))
        {
            System.IO.File.Copy(file, folder[Path.GetFileName(file)], overwrite: true);
        }

        return Job(folder["job.json"]);
    }

    /// <summary>A copy of the mating sample that is feedback. Its counterpart is half a millimeter off,
    /// so a corrected program lies that far from the key points.</summary>
    public static CellJobSettings Feedback(TemporaryFolder folder)
    {
        var job = Copied(folder);
        var text = System.IO.File.ReadAllText(job.File);
        Assert.Contains("\"from\": \"part\"", text, StringComparison.Ordinal);
        System.IO.File.WriteAllText(
            job.File,
            text.Replace(
                "\"from\": \"part\"",
                "\"from\": \"counterpart\"",
                StringComparison.Ordinal).Replace("\"mapMm\": 0.5", "\"mapMm\": 1", StringComparison.Ordinal));
        return job;
    }
}
