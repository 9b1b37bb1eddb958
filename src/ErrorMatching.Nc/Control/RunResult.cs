namespace ErrorMatching.Nc;

/// <summary>The results of a run so far: motions, and their problems and notes.</summary>
/// <param name="dialect">The control.</param>
/// <param name="motions">Receives the motions.</param>
internal sealed class RunResult(NcDialect dialect, NcMotions motions)
{
    private readonly List<NcProblem> _problems = [];
    private readonly HashSet<NcProblem> _said = [];
    private readonly List<NcNote> _notes = [];
    private readonly List<(int Block, int Joint)> _placeDependents = [];
    private readonly List<int> _toolChanges = [];
    private readonly List<(int Motions, int Block)> _poles = [];
    private readonly List<CompensationSwitch> _switches = [];

    public NcMotions Motions { get; } = motions;

    /// <summary>The block to which motions belong: the one being executed, or the one in this file that called a program of another
    /// file.</summary>
    public int Block { get; set; }

    public IReadOnlyList<NcProblem> Problems => _problems;

    public IReadOnlyList<NcNote> Notes => _notes;

    /// <summary>Blocks that depend on the tool's place, each with its joint.</summary>
    public IReadOnlyList<(int Block, int Joint)> PlaceDependents => _placeDependents;

    /// <summary>The joints with a tool change.</summary>
    public IReadOnlyList<int> ToolChanges => _toolChanges;

    /// <summary>Words that concern cutter compensation, in execution order.</summary>
    public IReadOnlyList<CompensationSwitch> CompensationSwitches => _switches;

    /// <summary>Reports what is wrong with the block, once, no matter how often it runs.</summary>
    /// <returns>The flag.</returns>
    public MotionFlags Problem(string code, string message, MotionFlags flag)
    {
        var problem = new NcProblem(code, Block, message);
        if (_said.Add(problem))
        {
            _problems.Add(problem);
        }

        return flag;
    }

    public MotionFlags UnknownWord(string what) =>
        Problem("unknown-word", $"\"{what}\" is not known to the dialect {dialect.Name}.", MotionFlags.UnknownWord);

    /// <summary>Reports control behavior that is not followed: stored at its first occurrence and counted from there on.</summary>
    public void Note(string code, string message)
    {
        var known = _notes.FindIndex(n => n.Code == code);
        if (known < 0)
        {
            _notes.Add(new(code, Block, 1, message));
        }
        else
        {
            _notes[known] = _notes[known] with { Count = _notes[known].Count + 1 };
        }
    }

    public void DependOnPlace() => _placeDependents.Add((Block, Motions.Length));

    /// <summary>The blocks that state a pole, each with the number of motions before it.</summary>
    public IReadOnlyList<(int Motions, int Block)> Poles => _poles;

    public void StatePole() => _poles.Add((Motions.Length, Block));

    public void ChangeTool() => _toolChanges.Add(Motions.Length);

    /// <summary>Records a word that concerns cutter compensation, for the block and the joint where the run is.</summary>
    public void Add(CompensationSwitch found) => _switches.Add(found with { Block = Block, Joint = Motions.Length });
}
