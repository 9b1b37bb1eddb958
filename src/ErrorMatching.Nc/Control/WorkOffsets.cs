using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The work offsets as far as the program itself sets them, and the selected one.</summary>
/// <param name="turn">True for a control whose work offsets can rotate.</param>
internal sealed class WorkOffsets(bool turn)
{
    private readonly Dictionary<(int Code, int Number), WorkOrigin> _known = [];

    public (int Code, int Number) Chosen { get; private set; } = (540, 0);

    /// <summary>True if something unseen could have selected another one.</summary>
    public bool IsUnsure { get; set; }

    /// <summary>The origin of the selected one.</summary>
    public WorkOrigin Origin => OriginOf(Chosen);

    public WorkOrigin OriginOf((int Code, int Number) offset) =>
        _known.TryGetValue(offset, out var known) ? known : new(Vector3.Zero, AxisSet.All, turn ? null : 0);

    public void Write((int Code, int Number) offset, WorkOrigin origin) => _known[offset] = origin;

    public void Choose((int Code, int Number) offset) => (Chosen, IsUnsure) = (offset, false);

    public void Forget()
    {
        _known.Clear();
        IsUnsure = true;
    }
}
