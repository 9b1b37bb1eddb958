using System.Globalization;
using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Writes a measuring plan as a table.</summary>
public static class PlanCsv
{
    /// <summary>The header: number of the point in the order of measuring, its place in the grid, the point on the nominal surface in millimetres, its unit normal out of the material, and why it is there.</summary>
    public const string Header = "point,i,j,x,y,z,nx,ny,nz,reason";

    /// <summary>One line a point by rising number, as UTF-8. Coordinates with six decimals, normals with nine.</summary>
    public static byte[] Write(MeasuringPlan plan)
    {
        ArgumentNullException.ThrowIfNull(plan);
        var text = new StringBuilder(Header).Append('\n');
        foreach (var p in plan.Points)
        {
            text.Append(CultureInfo.InvariantCulture, $"{p.Number},{p.I},{p.J},{Mm(p.Position.X)},{Mm(p.Position.Y)},{Mm(p.Position.Z)},{Unit(p.Normal.X)},{Unit(p.Normal.Y)},{Unit(p.Normal.Z)},{NameOf(p.Reason)}\n");
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

    // A minus before zeros only is none.
    private static string Mm(double value) => (Math.Round(value, 6) + 0.0).ToString("0.000000", CultureInfo.InvariantCulture);

    private static string Unit(double value) => (Math.Round(value, 9) + 0.0).ToString("0.000000000", CultureInfo.InvariantCulture);
}
