using System.Diagnostics;
using System.Reflection;

namespace ErrorMatching.Score;

/// <summary>
/// The tests of an area as a single test, for <c>tests/score</c>. The mutation tool then asks for one test for each mutant, in a process
/// that stays warm, and most mutants cost one short test: those that caught the last mutants run first, and the first failure ends the run.
/// </summary>
public sealed class AreaTest
{
    /// <summary>Processor time that no test of an area needs. Time on the clock would depend on the load of the machine.</summary>
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(double.Parse(
        Environment.GetEnvironmentVariable("SCORE_LIMIT_SECONDS") ?? "6", System.Globalization.CultureInfo.InvariantCulture));

    // None except under tests/score.
    private static readonly LinkedList<TestCase> Cases = Environment.GetEnvironmentVariable("SCORE_ASSEMBLY") is { } assembly
        ? new(TestCase.In(
            Assembly.Load(assembly),
            Environment.GetEnvironmentVariable("SCORE_CLASSES")!.Split(' ', StringSplitOptions.RemoveEmptyEntries)))
        : [];

    private const int None = -1;

    // A sample of the mutants, or those that survived before; all if null.
    private static readonly HashSet<string>? Only = Environment.GetEnvironmentVariable("SCORE_ONLY")?.Split(' ').ToHashSet();

    private static bool _isPrepared;

    [Fact]
    public void Every_test_of_the_area_passes()
    {
        Assert.SkipWhen(Cases.Count == 0, "Only tests/score runs it.");
        var mutant = ActiveMutant();
        if (Only?.Contains(Name(mutant)) == false)
        {
            Log(mutant, "skipped");
            return;
        }

        Prepare(mutant);
        var clock = Stopwatch.StartNew();
        for (var node = Cases.First; node is not null; node = node.Next)
        {
            if (Problem(node.Value) is not { } problem)
            {
                continue;
            }

            // The mutant is to blame only if the test passes without it.
            SwitchTo(None);
            if (Problem(node.Value) is { } other)
            {
                Log(mutant, $"unsound\t{other}\t{node.Value.Name}");
                Environment.Exit(3);
            }

            SwitchTo(mutant);
            Cases.Remove(node);
            Cases.AddFirst(node);
            Log(mutant, $"{problem}\t{clock.ElapsedMilliseconds}\t{node.Value.Name}");
            Assert.Fail($"{problem}: {node.Value.Name}");
        }

        Log(mutant, $"passed\t{clock.ElapsedMilliseconds}\t{Cases.Count}");
    }

    // What is static must not be initialized by a mutant, since it would stay for all that follow.
    private static void Prepare(int mutant)
    {
        if (_isPrepared)
        {
            return;
        }

        SwitchTo(None);
        foreach (var test in Cases)
        {
            if (Problem(test) is { } problem)
            {
                throw new InvalidOperationException($"{problem} without a mutant: {test.Name}");
            }
        }

        SwitchTo(mutant);
        _isPrepared = true;
    }

    // A test that never ends is left behind: its mutant is switched off next, which ends most loops.
    private static string? Problem(TestCase test)
    {
        string? problem = null;
        void Run()
        {
            try
            {
                test.RunAsync().GetAwaiter().GetResult();
            }
            catch (Exception e)
            {
                problem = $"failed\t{e.GetType().Name}";
            }
        }

        var thread = new Thread(Run) { IsBackground = true };
        var process = Process.GetCurrentProcess();
        var before = process.TotalProcessorTime;
        thread.Start();
        while (!thread.Join(200))
        {
            process.Refresh();
            if (process.TotalProcessorTime - before > Limit)
            {
                return "endless\t-";
            }
        }

        return problem;
    }

    private static void Log(int mutant, string line) =>
        File.AppendAllText(Environment.GetEnvironmentVariable("SCORE_LOG")!, $"{Name(mutant)}\t{line}\n");

    private static string Name(int mutant) => mutant.ToString(System.Globalization.CultureInfo.InvariantCulture);

    private static int ActiveMutant()
    {
        using var file = OpenSwitch();
        var number = new byte[sizeof(int)];
        return file?.ReadAtLeast(number, number.Length, throwOnEndOfStream: true) > 0 ? BitConverter.ToInt32(number) : None;
    }

    private static void SwitchTo(int mutant)
    {
        using var file = OpenSwitch();
        file?.Write(BitConverter.GetBytes(mutant));
    }

    // The mutation tool has it open, too.
    private static FileStream? OpenSwitch() => Environment.GetEnvironmentVariable("STRYKER_MUTANT_FILE") is { } path
        ? new(path, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete)
        : null;
}
