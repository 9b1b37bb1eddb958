using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The tool length that the program itself states (G43.1), mm along each axis.</summary>
internal sealed class ToolLength
{
    private bool _isInInches;

    public Vector3 Vector { get; private set; }

    /// <summary>Axes with a tool length.</summary>
    public AxisSet Axes => Vector.Axes();

    /// <summary>Axes with an unknown tool length: only the machine knows a length from the tool table. A length stated in other units is
    /// unknown too: LinuxCNC 2.9 keeps its number (measured with rs274).</summary>
    public AxisSet UnknownIn(in ModalState state) => (state.LengthOffset ? AxisSet.Z : AxisSet.None)
        | (_isInInches != state.Inch ? Axes : AxisSet.None);

    public void Change(Vector3 to, bool inInches) => (Vector, _isInInches) = (to, inInches);
}
