using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed class LateProgressTests
{
    [Fact]
    public void Nothing_is_shown_of_what_takes_less_than_a_second()
    {
        using var terminal = new StringWriter();
        var clock = new HandClock();
        using (var progress = new LateProgress(terminal, clock))
        {
            progress.Report("reading the surface");
            progress.Report(new RunProgress("planning the tool path", 0.5));
        }

        clock.Strike();
        Assert.Equal("", terminal.ToString());
    }

    [Fact]
    public void After_a_second_it_is_shown_what_is_done_until_it_is_done()
    {
        using var terminal = new StringWriter();
        var clock = new HandClock();
        using (var progress = new LateProgress(terminal, clock))
        {
            progress.Report("reading the surface");
            clock.Strike();
            Assert.Equal("\rreading the surface ...", terminal.ToString());
            progress.Report(new RunProgress("planning the tool path", 0.259));
            Assert.EndsWith("\rplanning the tool path: [#####...............] 25 %", terminal.ToString(), StringComparison.Ordinal);
        }

        var blank = new string(' ', "planning the tool path: [#####...............] 25 %".Length);
        Assert.EndsWith($"\r{blank}\r", terminal.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void A_second_in_which_nothing_was_reported_shows_nothing_and_nobody_is_told_without_a_terminal()
    {
        using var terminal = new StringWriter();
        var clock = new HandClock();
        using (var progress = new LateProgress(terminal, clock))
        {
            clock.Strike();
        }

        Assert.Equal("", terminal.ToString());
        using (var progress = new LateProgress(null, clock))
        {
            progress.Report("reading the surface");
        }
    }

    [Fact]
    public void A_compensation_tells_its_stages_and_the_share_of_the_path()
    {
        var told = new List<RunProgress>();
        var files = new FreeformFiles(Repository.PathTo("samples", "surface-two", "job.json"));
        var outcome = SurfaceRun.Compensate(
            files,
            new()
            {
                Measured = [new(Repository.PathTo("samples", "surface-two", "measured.csv"))],
                Progress = new Listener(told),
            },
            TestContext.Current.CancellationToken);

        Assert.True(outcome.IsUsable);
        Assert.Equal(
            ["reading the measurement", "fitting the error", "planning the tool path", "writing the program"],
            told.Select(t => t.Doing).Distinct());
        var shares = told.Where(t => t.Doing == "planning the tool path").Select(t => t.Share!.Value).ToArray();
        Assert.Equal(shares.Order(), shares);
        Assert.Equal(1, shares[^1], 1e-9);
        Assert.True(shares.Length > 50);
    }

    private sealed class Listener(List<RunProgress> told) : IProgress<RunProgress>
    {
        public void Report(RunProgress value) => told.Add(value);
    }

    /// <summary>A clock whose timers go off by hand.</summary>
    private sealed class HandClock : TimeProvider
    {
        private readonly List<(TimerCallback Callback, TimeSpan Due)> _timers = [];

        public void Strike()
        {
            foreach (var (callback, due) in _timers)
            {
                Assert.Equal(TimeSpan.FromSeconds(1), due);
                callback(null);
            }
        }

        public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
        {
            _timers.Add((callback, dueTime));
            return new NoTimer();
        }

        private sealed class NoTimer : ITimer
        {
            public bool Change(TimeSpan dueTime, TimeSpan period) => true;

            public void Dispose()
            {
            }

            public ValueTask DisposeAsync() => ValueTask.CompletedTask;
        }
    }
}
