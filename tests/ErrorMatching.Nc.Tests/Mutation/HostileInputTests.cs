using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Damaged programs through everything that reads, displaces and proves. <c>tests/mutate COUNT SEED</c> runs more of them:
/// it sets the two variables read here.
/// </summary>
public sealed class HostileInputTests
{
    // What one reading in one dialect may take: a constant, since a block of a few bytes may stand for a hundred thousand pecks,
    // or for a loop that is given up after half a million blocks, and so much for each byte of the program.
    // A machine that is busy with something else gets another try.
    private const double SecondsAtMost = 10;
    private const double SecondsPerByte = 1e-6;
    private const long BytesAtMost = 512 << 20;
    private const long BytesPerByte = 400;
    private const int Tries = 5;
    private const int MostFailures = 20;

    private static readonly long Count = Setting("ERRORMATCH_MUTATIONS", 600);
    private static readonly long FirstSeed = Setting("ERRORMATCH_MUTATION_SEED", 1);

    [Fact]
    public void Each_program_of_the_corpus_is_read_and_displaced_without_an_exception() =>
        Assert.All(Mutator.Corpus, p => Abuse(p.Bytes, 1));

    [Fact]
    public void No_damaged_program_throws_hangs_or_changes_elsewhere()
    {
        var failures = new List<string>();
        for (var seed = FirstSeed; seed < FirstSeed + Count && failures.Count < MostFailures; seed++)
        {
            var bytes = new Mutator(seed).Next();
            try
            {
                Abuse(bytes, seed);
            }
            catch (Exception e)
            {
                var file = Path.Combine(Path.GetTempPath(), $"errormatch-mutation-{seed}.nc");
                File.WriteAllBytes(file, bytes);
                failures.Add($"Seed {seed}, written to {file}: {e}");
            }
        }

        Assert.True(failures.Count == 0, string.Join("\n", failures));
    }

    private static void Abuse(byte[] bytes, long seed)
    {
        var draw = new Mutator(-seed);
        foreach (var dialect in NcDialects.All)
        {
            var program = NcProgram.Read(bytes, dialect.Syntax);
            Assert.True(Copied(program).AsSpan().SequenceEqual(bytes), $"{dialect.Name}: the tokens are not the program.");
            Assert.True(NcCensus.Of(program).RoundTrips, $"{dialect.Name}: the census says that they are not.");
            var path = Within(bytes.Length, $"{dialect.Name}: reading", () => NcInterpreter.Run(program, dialect));
            if (program.BlockCount > 0)
            {
                Displace(path, draw);
            }
        }
    }

    private static byte[] Copied(NcProgram program)
    {
        var copy = new List<byte>();
        for (var i = 0; i < program.BlockCount; i++)
        {
            foreach (var token in program.Tokens(program[i]))
            {
                copy.AddRange(program.Bytes.Span.Slice(token.Start, token.Length));
            }

            copy.AddRange(program.Bytes.Span[program[i].End..(program[i].Start + program[i].FullLength)]);
        }

        return [.. copy];
    }

    private static void Displace(NcPath path, Mutator draw)
    {
        var blocks = Blocks(path.Program, draw);
        var d = (draw.Below(61) - 30) / 100.0;
        var (isNormal, isLevel) = (draw.Below(2) == 0, draw.Below(3) != 0);
        var (wish, rewrite) = Within(path.Program.Bytes.Length, $"{path.Dialect.Name}: displacing", () =>
        {
            var wish = isNormal
                ? DisplacementWish.Normal(path, blocks, d)
                : DisplacementWish.EndsBy(path, blocks, new Vector3(d, -d, isLevel ? 0 : d / 2));
            return (wish, Rewrite: wish.IsUsable ? Rewriter.Apply(path, wish.Result) : null);
        });
        if (wish.Result is not { } wanted || rewrite is not { IsUsable: true, Result: { } result })
        {
            return;
        }

        var proof = Within(
            path.Program.Bytes.Length,
            $"{path.Dialect.Name}: proving",
            () => Prover.Check(path, result.Program, wanted, result.LeastIncrementMm));
        if (proof.Holds)
        {
            OnlyTheseDiffer(path.Program, result.Program, [.. blocks, .. proof.Neighbors.Select(n => n.Line - 1)]);
        }
    }

    private static int[] Blocks(NcProgram program, Mutator draw)
    {
        if (draw.Below(4) == 0
            && BlockSelector.Select(program, [BlockSelector.Parse("/[XY]-?[0-9]/")]) is { IsUsable: true, Result: var chosen })
        {
            return chosen;
        }

        if (draw.Below(4) == 0 && BlockSelector.Select(program, [BlockSelector.Parse("N10..N30")]) is { IsUsable: true, Result: var named })
        {
            return named;
        }

        var first = draw.Below(program.BlockCount);
        return [.. Enumerable.Range(first, 1 + draw.Below(Math.Min(20, program.BlockCount - first)))];
    }

    private static void OnlyTheseDiffer(NcProgram before, NcProgram after, HashSet<int> allowed)
    {
        Assert.Equal(before.BlockCount, after.BlockCount);
        for (var i = 0; i < before.BlockCount; i++)
        {
            Assert.True(
                allowed.Contains(i)
                    || before.Bytes.Span.Slice(before[i].Start, before[i].FullLength).SequenceEqual(
                        after.Bytes.Span.Slice(after[i].Start, after[i].FullLength)),
                $"line {i + 1} changed from \"{before.TextOf(before[i])}\" to \"{after.TextOf(after[i])}\" without having been named");
        }
    }

    private static T Within<T>(int length, string what, Func<T> work)
    {
        for (var attempt = 1; ; attempt++)
        {
            var (watch, allocated) = (Stopwatch.StartNew(), GC.GetAllocatedBytesForCurrentThread());
            var result = work();
            var (seconds, used) = (watch.Elapsed.TotalSeconds, GC.GetAllocatedBytesForCurrentThread() - allocated);
            Assert.True(used <= BytesAtMost + (BytesPerByte * length), $"{what} {length} bytes allocated {used} bytes.");
            if (seconds <= SecondsAtMost + (SecondsPerByte * length))
            {
                return result;
            }

            Assert.True(attempt < Tries, $"{what} {length} bytes took {seconds} s.");
        }
    }

    private static long Setting(string name, long otherwise) =>
        Environment.GetEnvironmentVariable(name) is { } text ? long.Parse(text, CultureInfo.InvariantCulture) : otherwise;
}
