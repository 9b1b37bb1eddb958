using System.Globalization;
using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Writes a measuring plan as a table.</summary>
public static class PlanCsv
{
    /// <summary>The header: number of the point in the order of measuring, its indices in the grid, the point on the nominal surface in
    /// millimeters, its unit normal out of the material, and the reason for the point.</summary>
    public const string Header = "point,i,j,x,y,z,nx,ny,nz,reason";

    /// <summary>Writes one line per point by ascending number, as UTF-8. Coordinates have six decimals, normals nine.</summary>
    public static byte[] Write(MeasuringPlan plan)
    {
        ArgumentNullException.ThrowIfNull(plan);
        var text = new StringBuilder(Header).Append('\n');
        foreach (var p in plan.Points)
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"{p.Number},{p.I},{p.J},{Mm(p.Position.X)},{Mm(p.Position.Y)},{Mm(p.Position.Z)},{Unit(p.Normal.X)},{Unit(p.Normal.Y)},"
                    + $"{Unit(p.Normal.Z)},{NameOf(p.Reason)}\n");
        }

        return Encoding.UTF8.GetBytes(text.ToString());
    }

    /// <summary>The word for a reason: end, slope or break.</summary>
    public static string NameOf(PlanReason reason) => reason switch
    {
        PlanReason.End => "end",
        PlanReason.Break => "break",
        _ => "slope",
    };

    // Avoids a negative zero.
    private static string Mm(double value) => (Math.Round(value, 6) + 0.0).ToString("0.000000", CultureInfo.InvariantCulture);

    private static string Unit(double value) => (Math.Round(value, 9) + 0.0).ToString("0.000000000", CultureInfo.InvariantCulture);
}
