using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The tool length that the program itself states (G43.1), mm along each axis, and the axes along which the machine's table gives
/// one.</summary>
internal sealed class ToolLength
{
    private bool _isInInches;

    public Vector3 Vector { get; private set; }

    /// <summary>Axes with a tool length that the program states.</summary>
    public AxisSet Axes => Vector.Axes();

    /// <summary>Axes with a length from the table, as long as one is active.</summary>
    public AxisSet FromTable { get; set; }

    /// <summary>True if something unseen could have activated another one.</summary>
    public bool IsUnsure { get; set; }

    /// <summary>Axes with an unknown tool length: only the machine knows a length from the tool table. A length stated in other units is
    /// unknown too: LinuxCNC 2.9 keeps its number (measured with rs274).</summary>
    public AxisSet UnknownIn(in ModalState state) => (state.LengthOffset ? FromTable : AxisSet.None)
        | (IsUnsure ? AxisSet.Z : AxisSet.None)
        | (_isInInches != state.Inch ? Axes : AxisSet.None);

    public void Change(Vector3 to, bool inInches) => (Vector, _isInInches) = (to, inInches);
}
