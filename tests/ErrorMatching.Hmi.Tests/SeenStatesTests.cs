using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A correction is seen until nothing follows it, and has words: a state that is in no list is seen by nobody.</summary>
public sealed class SeenStatesTests
{
    // Proposed a moment later. Until then the line of its slot counts it.
    private static readonly CorrectionState[] Hidden = [CorrectionState.Computed];

    public static TheoryData<CorrectionState> Open => [.. Enum.GetValues<CorrectionState>()
        .Where(s => !CorrectionSteps.IsEnd(s) || CorrectionSteps.Of(s).WaitsForRelease)];

    [Theory]
    [MemberData(nameof(Open))]
    public Task Whatever_has_not_ended_is_on_the_overview(CorrectionState state) => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            seat.WaitFor(() => seat.Station.State.Status?.CountOf(state) == 1, "The correction is not seen.");
            var overview = (OverviewViewModel)seat.Shell.Current!;
            var shown = overview.Waiting.Select(t => (long?)t.Id).Concat(overview.Slots.Select(t => t.Correction));
            Assert.Equal(Hidden.Contains(state) ? [] : [1], shown.OfType<long>());
            Assert.True(!Hidden.Contains(state) || overview.Slots[0].Waiting == "In line: 1", "Nobody sees that something is hidden.");
        },
        prepare: folder => Bring(folder, state));

    [Fact]
    public void Each_state_has_its_words()
    {
        string[] keys = [
            .. Enum.GetNames<CorrectionState>().SelectMany(s => new[] { "CorrectionState." + s, "Audited." + s.ToLowerInvariant() })];
        foreach (var language in Enum.GetValues<Language>())
        {
            var words = Texts.Of(language);
            Assert.All(keys, k => Assert.NotEmpty(words.GetValueOrDefault(k) ?? ""));
        }
    }

    // By the shortest way that the table has.
    private static void Bring(string folder, CorrectionState state)
    {
        var settings = CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json"));
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var slot = settings.Machines[0].Slots[0];
        var program = Encoding.ASCII.GetBytes("M30\n");
        var correction = store.Archive(new(settings.Gauges[0].Name, "part-1.csv", "1", Encoding.ASCII.GetBytes("1"), "trace")).Correction;
        foreach (var to in Way(state))
        {
            correction = store.Step(
                correction,
                to,
                "cell",
                "for the test",
                c => to switch
                {
                    CorrectionState.Recognized => c with
                    {
                        Job = settings.Jobs[0].Name,
                        Piece = PieceWords.Part,
                        Serial = "1",
                        Machine = settings.Machines[0].Name,
                        Slot = slot.Name,
                        Program = slot.Program,
                    },
                    CorrectionState.Computed => c with { ProgramSha256 = Convert.ToHexStringLower(SHA256.HashData(program)) },
                    _ => c,
                },
                [program]);
        }
    }

    private static CorrectionState[] Way(CorrectionState state)
    {
        var ways = new Dictionary<CorrectionState, CorrectionState[]> { [CorrectionState.Archived] = [] };
        var open = new Queue<CorrectionState>(ways.Keys);
        while (open.TryDequeue(out var at) && at != state)
        {
            // From a failed one, a step would skip what makes its program.
            if (at == CorrectionState.Failed) continue;
            foreach (var next in CorrectionSteps.From(at).Where(n => ways.TryAdd(n, [.. ways[at], n]))) open.Enqueue(next);
        }

        return ways[state];
    }
}
