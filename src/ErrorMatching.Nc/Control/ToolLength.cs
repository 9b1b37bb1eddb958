using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The tool length that the program itself states (G43.1), mm along each axis.</summary>
internal sealed class ToolLength
{
    private bool _isInInches;

    public Vector3 Vector { get; private set; }

    /// <summary>Axes along which there is one.</summary>
    public AxisSet Axes => Vector.Axes();

    /// <summary>
    /// Axes along which it is not known: a length from the tool table is the machine's affair. So is one that was stated in other units:
    /// LinuxCNC 2.9 keeps its number (measured with rs274).
    /// </summary>
    public AxisSet UnknownIn(in ModalState state) => (state.LengthOffset ? AxisSet.Z : AxisSet.None)
        | (_isInInches != state.Inch ? Axes : AxisSet.None);

    public void Change(Vector3 to, bool inInches) => (Vector, _isInInches) = (to, inInches);
}
