using System.Reflection;
using System.Text.RegularExpressions;
using ErrorMatching.Testing;
using Serilog.Events;

namespace ErrorMatching.Cell.Tests;

public sealed partial class CorrectionStepsTests
{
    [Fact]
    public void Every_state_has_its_row() => Assert.All(Enum.GetValues<CorrectionState>(), s => Assert.NotNull(CorrectionSteps.From(s)));

    [Fact]
    public void Every_state_but_the_first_is_reached_from_it()
    {
        var reached = new HashSet<CorrectionState> { CorrectionState.Archived };
        var open = new Queue<CorrectionState>(reached);
        while (open.TryDequeue(out var state))
        {
            foreach (var next in CorrectionSteps.From(state).Where(reached.Add))
            {
                open.Enqueue(next);
            }
        }

        Assert.Equal(Enum.GetValues<CorrectionState>().Order(), reached.Order());
    }

    [Theory]
    [InlineData(CorrectionState.Superseded), InlineData(CorrectionState.Recorded), InlineData(CorrectionState.Refused),
        InlineData(CorrectionState.Rejected), InlineData(CorrectionState.Reverted)]
    public void Nothing_follows_an_end(CorrectionState end) => Assert.True(CorrectionSteps.IsEnd(end));

    [Fact]
    public void Each_state_has_its_log_level() => Assert.Equal(
        [
            (CorrectionState.Archived, LogEventLevel.Debug), (CorrectionState.Recognized, LogEventLevel.Debug),
            (CorrectionState.Computed, LogEventLevel.Debug), (CorrectionState.Proposed, LogEventLevel.Information),
            (CorrectionState.Approved, LogEventLevel.Debug), (CorrectionState.Uploading, LogEventLevel.Debug),
            (CorrectionState.Verified, LogEventLevel.Information), (CorrectionState.Released, LogEventLevel.Information),
            (CorrectionState.Superseded, LogEventLevel.Warning), (CorrectionState.Recorded, LogEventLevel.Information),
            (CorrectionState.Refused, LogEventLevel.Warning), (CorrectionState.Rejected, LogEventLevel.Warning),
            (CorrectionState.Failed, LogEventLevel.Error), (CorrectionState.Reverted, LogEventLevel.Warning),
        ],
        Enum.GetValues<CorrectionState>().Select(s => (s, CorrectionSteps.Of(s).Level)));

    [Fact]
    public void What_is_true_of_a_state_fits_its_steps() => Assert.All(Enum.GetValues<CorrectionState>(), state =>
    {
        var row = CorrectionSteps.Of(state);
        var isEnd = CorrectionSteps.IsEnd(state);
        Assert.Equal(row.IsSent, CorrectionSteps.Allows(state, CorrectionState.Reverted));
        Assert.True(row.IsSettled || !isEnd, "An end is settled.");
        Assert.True(isEnd || !(row.IsSetAside || row.EndsTampered), "Only an end gets rid of a correction.");
        Assert.True(row.NamesProgram || !(row.HasSlot || row.WaitsForRelease || row.IsSent), "Only a program has a slot.");
        Assert.True(CorrectionSteps.Allows(state, CorrectionState.Approved) || !row.IsUndecided, "What waits can be approved.");
        Assert.True(row.TakenBy is null || !row.IsSettled, "Nobody takes on what is settled.");
    });

    [Fact]
    public void Nothing_reaches_the_machine_without_an_approval()
    {
        Assert.Equal(
            [CorrectionState.Approved], Enum.GetValues<CorrectionState>().Where(s => CorrectionSteps.Allows(s, CorrectionState.Uploading)));
        Assert.Equal(
            [CorrectionState.Uploading], Enum.GetValues<CorrectionState>().Where(s => CorrectionSteps.Allows(s, CorrectionState.Verified)));
    }

    [Fact]
    public void Each_step_names_the_methods_that_take_it()
    {
        var table = File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Cell", "States", "CorrectionSteps.cs"));
        var steps = Step().Matches(table);
        Assert.Equal(Enum.GetValues<CorrectionState>().Sum(s => CorrectionSteps.From(s).Count), steps.Count);
        Assert.All(steps.SelectMany(s => s.Groups["by"].Value.Split(", ")), by => Assert.NotEmpty(Named(by.Split('.'))));
    }

    private static MemberInfo[] Named(string[] method) =>
        typeof(CorrectionSteps).Assembly.GetType($"ErrorMatching.Cell.{method[0]}")?.GetMember(
            method[1], BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic) ?? [];

    [GeneratedRegex(@"CorrectionState\.\w+, // (?<by>.+)", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Step();
}
