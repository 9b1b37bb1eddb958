using BenchmarkDotNet.Attributes;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The paper's 14-point job (section 4.3, with the three flank points that the sample adds), in process. The paper needed 1
/// s.</summary>
[MemoryDiagnoser]
public class MatchBenchmarks
{
    private string _jobFile = "";
    private byte[] _jobBytes = [];
    private byte[] _theoretical = [];
    private byte[] _part = [];
    private byte[] _program = [];
    private MatchInput _input = null!;

    [GlobalSetup]
    public void Setup()
    {
        _jobFile = Repository.PathTo("samples", "complex-mating", "job.json");
        _jobBytes = File.ReadAllBytes(_jobFile);
        _theoretical = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "theoretical.csv"));
        _part = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "part.csv"));
        _program = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc"));
        _input = Read();
    }

    /// <summary>Map, fit, decide, displace, round, write, interpret again, prove.</summary>
    [Benchmark]
    public Outcome<MatchResult> Match() => Matcher.Match(_input);

    /// <summary>The same from the bytes of the files to the bytes of report.json.</summary>
    [Benchmark]
    public byte[] FilesToReport()
    {
        var outcome = Matcher.Match(Read());
        return MatchReportJson.Write(MatchReporter.Report(outcome.Result!, "counterpart.nc", 0));
    }

    private MatchInput Read()
    {
        var job = MatingJob.Parse(_jobBytes, _jobFile);
        return new(
            job,
            MeasurementReader.Read(_theoretical, "theoretical.csv", MeasurementFormat.Points),
            MeasurementReader.Read(_part, "part.csv", job.Gauge.Format),
            null,
            "counterpart.nc",
            _program);
    }
}
