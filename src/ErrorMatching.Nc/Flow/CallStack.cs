namespace ErrorMatching.Nc;

/// <summary>The programs being executed, innermost last.</summary>
/// <param name="main">The file in which the run began.</param>
/// <param name="dialect">Its control.</param>
internal sealed class CallStack(NcProgram main, NcDialect dialect)
{
    public NcProgram Main => main;

    /// <summary>Names of the programs that were called.</summary>
    public HashSet<string> Called { get; } = new(StringComparer.Ordinal);

    /// <summary>Empty until a statement needs the index of the file; a straight program with M30 at its end never does.</summary>
    public Stack<FlowFrame> Frames { get; } = new();

    public FlowFrame Frame
    {
        get
        {
            if (Frames.Count == 0)
            {
                var unit = new FlowIndex(main, dialect).Main;
                Frames.Push(new() { Unit = unit, First = unit.First });
            }

            return Frames.Peek();
        }
    }

    public FlowUnit Unit => Frame.Unit;

    /// <summary>The file being executed: the program itself, or one of the library.</summary>
    public NcProgram Program => Frames.Count == 0 ? main : Unit.Index.Program;

    /// <summary>Call depth of the current block; 0 in the main program.</summary>
    public int Depth => Math.Max(0, Frames.Count - 1);

    /// <summary>The block of the main file: for a block of another file, the block that called it.</summary>
    public int InProgram(int block)
    {
        foreach (var frame in Frames)
        {
            block = ReferenceEquals(frame.Unit.Index.Program, main) ? block : frame.Caller;
        }

        return block;
    }
}
