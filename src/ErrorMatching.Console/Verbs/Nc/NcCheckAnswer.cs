using System.Globalization;
using System.Text.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>The contents of a program, and the parts of it that are not understood.</summary>
internal sealed class NcCheckAnswer(string file, NcPath path, NcCensus census, bool isStrict) : DocumentAnswer
{
    private const int MostShown = 200;

    private readonly Understanding _understanding = new(path);

    public override string Schema => "errormatch/nc-check/1";

    private readonly DialectFit? _otherDialect = DialectFit.Of(path.Program, path.Dialect);

    private readonly Refusal? _compensation = CompensatedPath.Check(path);

    public override Failure? Failure => (path.Refusal ?? Stop ?? (isStrict ? _understanding.Refusal : null)) is { } refusal
        ? FailureOf.Refused(file, refusal)
        : null;

    // Where nobody stated the tool, only a note says what the control would do.
    private Refusal? Stop => _compensation is { } stop && CompensatedPath.Stops(stop) && path.Dialect.ToolRadii.AreStated ? stop : null;

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("dialect", path.Dialect.Name);
        json.WriteNumber("bytes", path.Program.Bytes.Length);
        json.WriteNumber("blocks", census.Blocks);
        json.WriteNumber("words", census.Words);
        json.WriteNumber("motions", path.Motions.Length);
        json.WriteBoolean("roundTrip", census.RoundTrips);
        WriteProblems(json, "unknownWords", path.Problems.Where(p => p.Code is "unknown-word" or "unknown-code"));
        WriteProblems(json, "problems", path.Problems);
        json.WriteStartObject("understanding");
        json.WriteNumber("blocksNotUnderstood", _understanding.Blocks.Count);
        json.WriteNumber("blocksSkipped", _understanding.Skipped);
        json.WriteNumber("blocksEitherWay", path.UncertainBlocks.Count);
        json.WriteNumber("motionsOnlyTheMachineKnows", _understanding.OfMachine);
        json.WriteString("sentence", _understanding.Sentence);
        if (_otherDialect is { } other)
        {
            json.WriteString("dialect", other.Sentence);
            json.WriteString("betterDialect", other.Better?.Name);
        }

        json.WriteEndObject();
        json.WriteStartArray("programmed");
        foreach (var note in Programmed())
        {
            json.WriteStringValue(note);
        }

        json.WriteEndArray();
        WriteCompensation(json);
        ShownNotes.Write(json, (file, path));
        if (Failure is { } failure)
        {
            OutcomeWriter.WriteErrors(json, failure);
        }
    }

    public override void WriteText(Page page)
    {
        page.Heading($"{file}, dialect {path.Dialect.Name}");
        page.Line();
        if (_otherDialect is { } other)
        {
            page.Line(other.Sentence);
            page.Line();
        }

        page.Facts(
        [
            ("blocks", Count(census.Blocks)),
            ("words", Count(census.Words)),
            ("motions", Count(path.Motions.Length)),
            (
                "round trip",
                census.RoundTrips
                    ? $"copied word by word: all {Count(path.Program.Bytes.Length)} bytes are the same"
                    : "copied word by word, the bytes differ"),
        ]);
        foreach (var note in Programmed())
        {
            page.Line("Note: " + note);
        }

        ShownNotes.Write(page, (file, path));

        page.Line();
        if (path.Problems.Count > 0)
        {
            page.Table(
                ["line", "block", "what is not understood, or good to know"],
                path.Problems.Take(MostShown).Select(p => (IReadOnlyList<string>)[Count(p.Block + 1), NumberOf(p), p.Message]));
            page.Line();
        }

        if (path.Problems.Count > MostShown)
        {
            page.Line($"... and {Count(path.Problems.Count - MostShown)} more; --json lists them all.");
            page.Line();
        }

        page.Line(_understanding.Sentence);
    }

    // What a reader of the motions must know: they are the programmed path, not the path that the machine travels.
    private List<string> Programmed()
    {
        var notes = new List<string>();
        var (compensated, cycles, references, unknown) = (0, 0, 0, 0);
        foreach (var motion in path.Motions)
        {
            compensated += motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight) ? 1 : 0;
            cycles += motion.Kind == MotionKind.Cycle ? 1 : 0;
            references += motion.Kind == MotionKind.Reference ? 1 : 0;
            unknown += motion.UnknownEnd != AxisSet.None ? 1 : 0;
        }

        Note(compensated, "run under cutter compensation, which is not applied: the path is as programmed");
        if (compensated > 0)
        {
            notes.Add(_compensation is { } refusal
                ? $"The path of the tool's center: {refusal.Message}"
                : "The control can lead the tool's center along this contour; nc motion --compensated prints its path."
                    + (path.UnfollowedWays.Count > 0 ? " Of the ways to and from it that are not followed, this says nothing." : ""));
        }

        Note(cycles, "belong to cycles that are not followed: only their positions are known");
        Note(references, "go to a position of the machine, which the program does not say");
        Note(unknown, "end where at least one coordinate is not said by the program");
        if (!path.Motions.FollowBlocks)
        {
            var runs = Enumerable.Range(0, path.Program.BlockCount).Select(b => path.MotionsOf(b).Length).ToArray();
            Note(path.Motions.Length - runs.Count(r => r > 0), "come from blocks that run again, in loops and subprograms");
        }

        return notes;

        void Note(int count, string what)
        {
            if (count > 0)
            {
                notes.Add($"{Count(count)} of {Count(path.Motions.Length)} motions {what}.");
            }
        }
    }

    // What the control makes of the contour under G41 and G42.
    private void WriteCompensation(Utf8JsonWriter json)
    {
        if (!CompensatedPath.Concerns(path))
        {
            return;
        }

        json.WriteStartObject("compensation");
        json.WriteBoolean("followed", _compensation is null);
        json.WriteBoolean("stops", _compensation is { } refusal && CompensatedPath.Stops(refusal));
        json.WriteString("code", _compensation?.Code);
        json.WriteString("message", _compensation?.Message);
        json.WriteEndObject();
    }

    private void WriteProblems(Utf8JsonWriter json, string name, IEnumerable<NcProblem> problems)
    {
        json.WriteStartArray(name);
        foreach (var problem in problems)
        {
            json.WriteStartObject();
            json.WriteString("code", problem.Code);
            json.WriteNumber("line", problem.Block + 1);
            json.WriteString("block", NumberOf(problem));
            json.WriteString("message", problem.Message);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private string NumberOf(NcProblem problem) => path.Program.NumberOf(path.Program[problem.Block]);

    private static string Count(long count) => count.ToString(CultureInfo.InvariantCulture);
}
