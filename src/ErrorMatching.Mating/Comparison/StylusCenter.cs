using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>From the center of a stylus ball to the point where it touched.</summary>
/// <remarks>
/// <para>Across the boundary, along the normal that points from the counterpart's material to its tool:</para>
/// <code>
///     counterpart's material  |  tool while cutting; the part's material when both are assembled
///     -----------------------------------------------------------------------------------> normal
///        ball on the part (o) |  part
///                 counterpart | (o) ball on the counterpart
/// </code>
/// <para>
/// The ball is always in the air of the piece that it measures. The part fills the room that the tool has cleared, so its air is where the
/// counterpart's material is: the ball's center lies a radius before the contact along the normal, and contact = center + radius * normal.
/// The counterpart's air is where the tool was: contact = center - radius * normal. With the measured piece's own normal, out of its
/// material, both read contact = center - radius * normal.
/// </para>
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
