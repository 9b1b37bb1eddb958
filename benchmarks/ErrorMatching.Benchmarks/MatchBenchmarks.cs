using BenchmarkDotNet.Attributes;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The paper's 14-point job (section 4.3, with the three flank points that the sample adds), in process. The paper needed 1 s.</summary>
[MemoryDiagnoser]
public class MatchBenchmarks
{
    private string jobFile = "";
    private byte[] jobBytes = [];
    private byte[] theoretical = [];
    private byte[] part = [];
    private byte[] program = [];
    private MatchInput input = null!;

    [GlobalSetup]
    public void Setup()
    {
        jobFile = Repository.PathTo("samples", "complex-mating", "job.json");
        jobBytes = File.ReadAllBytes(jobFile);
        theoretical = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "theoretical.csv"));
        part = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "part.csv"));
        program = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc"));
        input = Read();
    }

    /// <summary>Map, fit, decide, displace, round, write, interpret again, prove.</summary>
    [Benchmark]
    public MatchOutcome Match() => Matcher.Match(input);

    /// <summary>The same from the bytes of the files to the bytes of report.json.</summary>
    [Benchmark]
    public byte[] FilesToReport()
    {
        var outcome = Matcher.Match(Read());
        return MatchReportJson.Write(MatchReporter.Report(outcome.Result!, "counterpart.nc", 0));
    }

    private MatchInput Read()
    {
        var job = MatingJob.Parse(jobBytes, jobFile);
        return new(
            job,
            MeasurementReader.Read(theoretical, "theoretical.csv", MeasurementFormat.Points),
            MeasurementReader.Read(part, "part.csv", job.Gauge.Format),
            null,
            "counterpart.nc",
            program);
    }
}
