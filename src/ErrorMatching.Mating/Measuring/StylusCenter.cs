using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Converts the center of a stylus ball to the contact point.</summary>
/// <remarks>
/// <para>Across the boundary, along the normal that points from the counterpart's material to its tool:</para>
/// <code>
///     counterpart's material  |  tool while cutting; the part's material when both are assembled
///     -----------------------------------------------------------------------------------> normal
///        ball on the part (o) |  part
///                 counterpart | (o) ball on the counterpart
/// </code>
/// <para>The ball is always outside the material of the piece that it measures. The part fills the space that the tool cleared, so the
/// space outside the part is where the counterpart's material is: the ball's center is one radius before the contact along the normal,
/// and contact = center + radius * normal. The space outside the counterpart is where the tool was: contact = center - radius * normal.
/// With the measured piece's own outward normal, both are contact = center - radius * normal.</para>
/// </remarks>
internal static class StylusCenter
{
    /// <summary>The point of contact.</summary>
    /// <param name="center">Center of the ball at the moment of touch, in the part's frame.</param>
    /// <param name="radiusMm">Radius of the ball.</param>
    /// <param name="normal">Unit normal from the counterpart's material to its tool.</param>
    /// <param name="piece">Which piece was touched.</param>
    public static Point2 ToContact(Point2 center, double radiusMm, Vector2 normal, MeasuredPiece piece) =>
        center + (normal * (piece == MeasuredPiece.Part ? radiusMm : -radiusMm));
}

/// <summary>Which of the two pieces was measured.</summary>
internal enum MeasuredPiece
{
    /// <summary>The part: its material is on the tool's side of the boundary that the counterpart's tool cuts.</summary>
    Part,

    /// <summary>The counterpart: its material is on the other side.</summary>
    Counterpart,
}
