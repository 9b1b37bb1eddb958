using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The position of a run: the file and the block, and the <see cref="NcFlow"/> that decides where it continues, created when a
/// block first needs it.</summary>
internal sealed class ProgramRun(
    NcControl control, NcProgram program, Func<string, NcProgram?>? library, CancellationToken cancellation)
{
    /// <summary>Number of blocks that may run before a program counts as endless (some tenths of a second); long files get more.</summary>
    private const long LeastSteps = 500_000;

    /// <summary>Number of holes and pecks of one program that are followed: a block of a few bytes can request any number.</summary>
    public const int MostHoles = 100_000;

    private const long StepsPerBlock = 10;
    private const int LongestShown = 60;

    private readonly List<CalledProgram> _called = [];
    private NcFlow? _flow;

    public NcProgram Program { get; } = program;

    public Func<string, NcProgram?>? Library => library;

    public CancellationToken Cancellation => cancellation;

    /// <summary>The current file: the program itself, or one that it calls.</summary>
    public NcProgram Text { get; private set; } = program;

    /// <summary>The block of the file that runs, or runs next.</summary>
    public int At { get; set; }

    public bool HasEnded { get; set; }

    /// <summary>Holes and pecks so far.</summary>
    public double Holes { get; set; }

    /// <summary>Says which way the program goes where only the machine knows it; null if both ways do not lead to the same.</summary>
    public Func<bool?> Decide { get; set; } = () => null;

    /// <summary>Called when a pass of a call ends, with the depth of that call.</summary>
    public Action<int> Returned { get; set; } = _ => { };

    public bool IsInProgram => ReferenceEquals(Text, Program);

    /// <summary>True once a block has needed the flow.</summary>
    public bool HasFlow => _flow is not null;

    public bool HasModalCall => _flow is { HasModalCall: true };

    public int CallDepth => _flow?.Depth ?? 0;

    public NcFlow Flow => _flow ??= new(Program, control.Dialect, new()
    {
        Library = Called,
        Returned = depth => Returned(depth),
        Decide = () => Decide(),
        Steps = LeastSteps + (StepsPerBlock * Program.BlockCount),
        Cancellation = cancellation,
    });

    /// <summary>The programs of other files that the run called, in order of their first call.</summary>
    public IReadOnlyList<CalledProgram> CalledPrograms => _called;

    public IReadOnlyList<NcNote> FlowNotes => _flow?.Notes ?? [];

    public Refusal? Refusal => _flow?.Refusal;

    // The flow asks once for each name.
    private NcProgram? Called(string name)
    {
        if (library?.Invoke(name) is not { } called)
        {
            return null;
        }

        _called.Add(new(name, ContentHash.Sha256(called.Bytes.Span)));
        return called.In(control.Dialect.Syntax);
    }

    /// <summary>Continues where the flow decided.</summary>
    public void Follow(FlowAction action)
    {
        HasEnded |= action == FlowAction.Stop;
        (Text, At) = (Flow.Program, Flow.Next);
    }

    /// <summary>Marks the values of machine variables as unknown.</summary>
    public void ForgetMachine() => _flow?.Variables.ForgetMachine();

    /// <summary>Computes a value: NaN if only the machine knows it, null if it is a variable that was never set.</summary>
    public double? Compute(int start, int length) =>
        !Flow.TryValue(At, start, length, control.LeastDecimals, out var value) || value.Kind is NcValueKind.Unknown or NcValueKind.Text
            ? double.NaN
        : value.IsVacant ? null
        : value.Number;

    public bool IsVariable(ReadOnlySpan<byte> name) => Flow.Variables.Knows(Encoding.ASCII.GetString(name).ToUpperInvariant());

    public ReadOnlySpan<byte> BytesOf(NcToken token) => Text.Bytes.Span.Slice(token.Start, token.Length);

    /// <summary>The name at the start of a statement.</summary>
    public ReadOnlySpan<byte> NameOf(NcToken statement)
    {
        var bytes = BytesOf(statement);
        if (LanguageSpelling.Of(control.Dialect.Syntax) is { } language)
        {
            return language.NameOf(bytes);
        }

        var length = 0;
        while (length < bytes.Length && SyntaxBytes.IsNamePart(bytes[length]))
        {
            length++;
        }

        return bytes[..length];
    }

    /// <summary>A word as written, or the beginning of one that is too long to show.</summary>
    public string TextOf(NcToken token) => token.Length <= LongestShown ? NcText.Decode(BytesOf(token))
        : NcText.Decode(BytesOf(token)[..LongestShown]) + "...";
}
