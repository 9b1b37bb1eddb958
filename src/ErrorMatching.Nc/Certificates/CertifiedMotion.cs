using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A motion that was named or changed, as a certificate states it.</summary>
/// <param name="Motion">Its position in the path.</param>
/// <param name="As">What it is to the judge.</param>
/// <param name="Element">Its wish, if an element was named.</param>
/// <param name="Carrier">How far its line moved to the left in the middle and how much it tilted (radians), or how its circle's center
/// moved and its radius grew; null if the motion itself does not determine it.</param>
/// <param name="By">The wished displacement of its end, if end points were named.</param>
/// <param name="Start">How its start moved.</param>
/// <param name="Middle">How the middle of an arc moved in its plane.</param>
/// <param name="End">How its end moved.</param>
internal sealed record CertifiedMotion(
    int Motion, CertifiedAs As, ElementWish? Element, Carried? Carrier, Vector3 By, Vector3 Start, Vector2? Middle, Vector3 End);

/// <summary>How the line or circle of an element moved: a shift to the left with a tilt, or of the center with a growth.</summary>
/// <param name="Shift">Shift of a line to the left, mm.</param>
/// <param name="Tilt">Tilt of a line to the left, mm per mm of its length.</param>
/// <param name="Center">Displacement of a center, mm.</param>
/// <param name="Growth">Growth of a radius, mm.</param>
internal readonly record struct Carried(double Shift, double Tilt, Vector2 Center, double Growth);

/// <summary>What a motion is to the judge.</summary>
internal enum CertifiedAs : byte
{
    /// <summary>A named line.</summary>
    Line,

    /// <summary>A named arc.</summary>
    Arc,

    /// <summary>A named arc that stays tangent to both named lines beside it.</summary>
    Fillet,

    /// <summary>A named line that shrank to a point.</summary>
    Shrunk,

    /// <summary>A motion whose end point was named.</summary>
    Point,

    /// <summary>An unnamed cut whose end slid along it.</summary>
    Slides,

    /// <summary>An unnamed cut that follows its end.</summary>
    Follows,

    /// <summary>An unnamed arc that stays tangent to both named lines beside it.</summary>
    FollowedFillet,

    /// <summary>Positioning to or from a moved place.</summary>
    Positioning,
}
