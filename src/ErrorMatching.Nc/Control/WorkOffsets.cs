using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The work offsets as far as the program itself sets them, and the selected one.</summary>
/// <param name="dialect">The control.</param>
internal sealed class WorkOffsets(NcDialect dialect)
{
    private readonly Dictionary<(int Code, int Number), WorkOrigin> _known = [];

    // LinuxCNC's work offsets can rotate.
    private readonly bool _turn = dialect.Syntax == NcSyntax.LinuxCnc;

    public (int Code, int Number) Chosen { get; private set; } = (dialect.FirstWorkOffset, 0);

    /// <summary>True if something unseen, or a value that only the machine knows, could have selected another one.</summary>
    public bool IsUnsure { get; set; }

    /// <summary>The origin of the selected one.</summary>
    public WorkOrigin Origin => IsUnsure ? Unknown : OriginOf(Chosen);

    private WorkOrigin Unknown => new(Vector3.Zero, AxisSet.All, _turn ? null : 0);

    public WorkOrigin OriginOf((int Code, int Number) offset) => _known.TryGetValue(NameOf(offset), out var known) ? known : Unknown;

    /// <summary>Whether it is the selected one, by any of its names; null if nobody knows.</summary>
    public bool? IsChosen((int Code, int Number) offset) =>
        IsUnsure ? null
        : NameOf(offset) == NameOf(Chosen) ? true
        : dialect.WorkOffsetOf(Chosen).IsInTable ? false
        : null;

    public void Write((int Code, int Number) offset, WorkOrigin origin) => _known[NameOf(offset)] = origin;

    public void Choose((int Code, int Number) offset, bool isKnown) => (Chosen, IsUnsure) = (offset, !isKnown);

    public void Forget()
    {
        _known.Clear();
        IsUnsure = true;
    }

    private (int Code, int Number) NameOf((int Code, int Number) offset) => dialect.WorkOffsetOf(offset).Offset;
}
