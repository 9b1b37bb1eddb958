using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The shift of the origin on top of the work offset (G92, G52).</summary>
internal sealed class OriginShift
{
    public Vector3 Vector { get; set; }

    /// <summary>Axes in which it is unknown.</summary>
    public AxisSet Unknown { get; set; }

    /// <summary>The part set by G52.</summary>
    public (Vector3 Vector, AxisSet Unknown) Local { get; set; }

    /// <summary>The shift that G92.3 restores; until the program sets a shift itself, only the machine knows it.</summary>
    public (Vector3 Vector, AxisSet Unknown) Stored { get; private set; } = (Vector3.Zero, AxisSet.All);

    public void Keep() => Stored = (Vector, Unknown);

    public void Forget() => (Unknown, Stored, Local) = (AxisSet.All, (Vector3.Zero, AxisSet.All), (Vector3.Zero, AxisSet.All));
}
