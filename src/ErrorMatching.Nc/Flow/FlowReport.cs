using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Why a running program cannot continue, and notes on how it ran.</summary>
internal sealed class FlowReport(CallStack calls)
{
    private readonly List<NcNote> _notes = [];
    private readonly HashSet<(string Code, int Block)> _noted = [];

    /// <summary>Why the program cannot continue; null if it can.</summary>
    public Refusal? Refusal { get; private set; }

    public IReadOnlyList<NcNote> Notes => _notes;

    /// <summary>Ends the run at a place of a block, a column from 1, with a reason.</summary>
    public FlowAction Refuse(string code, int block, int column, string message)
    {
        var isFirst = Refusal is null;
        var action = Refuse(code, block, ReferenceEquals(calls.Program, calls.Main) ? message
            : System.FormattableString.Invariant($"column {column}: {message}"));
        if (isFirst && ReferenceEquals(calls.Program, calls.Main))
        {
            Refusal = Refusal! with { Place = Refusal.Place with { Column = column } };
        }

        return action;
    }

    /// <summary>Ends the run at a block with a reason.</summary>
    public FlowAction Refuse(string code, int block, string message)
    {
        var (program, called) = (calls.Main, calls.Program);
        var main = calls.InProgram(block);
        if (ReferenceEquals(called, program))
        {
            Refusal ??= program.BlockCount == 0 ? new(code, message)
                : BlockRefusal.At(program, Math.Clamp(main, 0, program.BlockCount - 1), code, message);
        }
        else
        {
            // The setter's file has the calling block; the message gives the place in the other file.
            var name = calls.Unit.Name.Length > 0 ? calls.Unit.Name : "the called program";
            var where = called.BlockCount == 0 ? "" : $", {called.NameOf(called[Math.Clamp(block, 0, called.BlockCount - 1)])}";
            Refusal ??= BlockRefusal.At(program, main, code, $"in {name}{where}: {message}");
        }

        return FlowAction.Stop;
    }

    public FlowAction Missing(int block, string name) =>
        Refuse(NcRefusalCodes.MissingProgram, block,
            $"the program {name} is called, and neither this file nor the folder of the program has it.");

    /// <summary>Refuses a call that cannot be executed, or a block with two flow words.</summary>
    public FlowAction RefuseCall(int block, string word) => Refuse(
        NcRefusalCodes.MissingProgram,
        block,
        $"{word} calls or steers a program in a way that is not followed, or one that is looked for elsewhere: what it does is not known. "
            + "Put its blocks in the place of the call.");

    public void Note(string code, int block, string message)
    {
        block = calls.InProgram(block);
        if (_noted.Add((code, block)))
        {
            _notes.Add(new(code, block, 1, message));
        }
    }
}
