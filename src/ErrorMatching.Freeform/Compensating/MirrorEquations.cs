using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The paper's two equations (Lee 2019, section 2.4) and their combination.</summary>
/// <remarks>
/// Let e be the error of the semi-finished surface: its height above the ideal surface plus stock. The measured point is P_R = P_P +
/// (stock + e) V_N. With P_M = P_P + stock / 2 V_N and D_M = stock / 2 + e,
/// the compensation point is P_C = P_R - 2 D_M V_N = P_P - e V_N: the ideal point moved by the error to the other side.
/// </remarks>
internal static class MirrorEquations
{
    /// <summary>Equation (1): the point of the mirror surface, P_M = P_P + D_H V_N, with D_H half the stock of semi-finishing.</summary>
    /// <param name="ideal">P_P, on the ideal finished surface, in millimeters.</param>
    /// <param name="normal">V_N, unit normal out of the material.</param>
    /// <param name="stockMm">Stock of semi-finishing.</param>
    public static Point3 MirrorPoint(Point3 ideal, Vector3 normal, double stockMm) => ideal + (normal * (stockMm / 2));

    /// <summary>Equation (2): the compensation point, P_C = P_R - 2 D_M V_N, with D_M the signed distance from P_M to P_R along the
    /// normal.</summary>
    /// <param name="measured">P_R, on the semi-finished surface, in millimeters.</param>
    /// <param name="mirror">P_M, from <see cref="MirrorPoint"/>.</param>
    /// <param name="normal">V_N, unit normal out of the material.</param>
    public static Point3 CompensationPoint(Point3 measured, Point3 mirror, Vector3 normal) =>
        measured + (normal * (-2 * (measured - mirror).Dot(normal)));

    /// <summary>Both equations in one, with a gain: P_C = P_P - gain e V_N.</summary>
    /// <param name="ideal">P_P, on the ideal finished surface, in millimeters.</param>
    /// <param name="normal">V_N, unit normal out of the material.</param>
    /// <param name="errorMm">e, positive out of the material.</param>
    /// <param name="gain">Share of the error that is compensated; 1 is the pure mirror.</param>
    public static Point3 Compensated(Point3 ideal, Vector3 normal, double errorMm, double gain) => ideal + (normal * (-gain * errorMm));
}
