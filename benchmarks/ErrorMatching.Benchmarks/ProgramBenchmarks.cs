using System.Globalization;
using System.Text;
using BenchmarkDotNet.Attributes;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Benchmarks;

/// <summary>A program of 100,000 blocks: find 10,000 of them, displace them, prove the result.</summary>
[MemoryDiagnoser]
public class ProgramBenchmarks
{
    private const int Blocks = 100_000;
    private const string Range = "N450000..N549990";

    private NcProgram _program = null!;
    private NcPath _path = null!;
    private DisplacementWish _wish = null!;
    private Rewrite _rewrite = null!;

    /// <summary>A wave of closely spaced points, 0.2 mm per block, in the style of a common postprocessor.</summary>
    public static byte[] Wave(int blocks)
    {
        var text = new StringBuilder("%\nO1000\nN10 G21 G17 G40 G90 G54\nN20 G0 X0. Y0. Z5.\nN30 G1 Z-2. F500.\n");
        for (var i = 4; i <= blocks; i++)
        {
            text.Append(CultureInfo.InvariantCulture, $"N{i * 10} X{0.2 * i:0.###} Y{20 * Math.Sin(0.002 * i):0.###}\n");
        }

        return Encoding.ASCII.GetBytes(text.Append("M30\n%\n").ToString());
    }

    [GlobalSetup]
    public void Setup()
    {
        _program = NcProgram.Read(Wave(Blocks));
        _path = Interpret();
        _wish = DisplacementWish.Normal(_path, Locate(), 0.02).Result!;
        _rewrite = Displace().Result!;
        if (!Prove().Holds)
        {
            throw new InvalidOperationException("The benchmark's own displacement is not proved.");
        }
    }

    [Benchmark]
    public NcPath Interpret() => NcInterpreter.Run(_program, NcDialects.FanucMill);

    [Benchmark]
    public int[] Locate() => BlockSelector.Select(_program, [BlockSelector.Parse(Range)]).Result!;

    [Benchmark]
    public Outcome<Rewrite> Displace() => Rewriter.Apply(_path, _wish);

    [Benchmark]
    public NcProof Prove() => Prover.Check(_path, _rewrite.Program, _wish, _rewrite.LeastIncrementMm);
}
