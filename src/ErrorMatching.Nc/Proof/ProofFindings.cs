using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Findings of a proof: failures, motions that moved along, and the largest distance from a wished place.</summary>
internal sealed class ProofFindings(NcPath before)
{
    private readonly List<Refusal> _failures = [];
    private readonly List<ProofNeighbor> _neighbors = [];
    private readonly Dictionary<(int Block, NeighborRole Role), int> _noted = [];

    public IReadOnlyList<Refusal> Failures => _failures;

    public IReadOnlyList<ProofNeighbor> Neighbors => _neighbors;

    public double MaxDeviation { get; private set; }

    /// <summary>A failure at a block of the original.</summary>
    public static Refusal Failure(NcPath before, int block, string what) =>
        BlockRefusal.At(before.Program, block, NcRefusalCodes.ProofFailed, what);

    public void Fail(int block, string what) => _failures.Add(Failure(before, block, what));

    /// <summary>A failure of the result as a whole.</summary>
    public void Fail(string what) => _failures.Add(new(NcRefusalCodes.ProofFailed, what));

    public void Add(Refusal failure) => _failures.Add(failure);

    public void Measure(int block, double deviation, double tolerance)
    {
        MaxDeviation = Math.Max(MaxDeviation, deviation);
        if (!(deviation <= tolerance))
        {
            Fail(block, FormattableString.Invariant($"it lies {deviation:0.0000} mm from where it was wanted."));
        }
    }

    /// <summary>Notes a motion that moved along.</summary>
    public void Note(in NcMotion was, in NcMotion now, NeighborRole role) => Note(was, role, ProofTask.Moved(was, now));

    /// <summary>Notes a motion that moved along by a length, mm. A block that runs several times is one neighbor with its largest
    /// displacement.</summary>
    public void Note(in NcMotion was, NeighborRole role, double moved)
    {
        if (_noted.TryAdd((was.Block, role), _neighbors.Count))
        {
            _neighbors.Add(new(before.Program.NameOf(before.Program[was.Block]), was.Block + 1, role, moved));
        }
        else
        {
            var noted = _noted[(was.Block, role)];
            _neighbors[noted] = _neighbors[noted] with { DisplacementMm = Math.Max(_neighbors[noted].DisplacementMm, moved) };
        }
    }
}
