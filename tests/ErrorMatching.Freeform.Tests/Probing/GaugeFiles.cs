using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Points as gauges export them, in the formats that describe themselves.</summary>
internal static class GaugeFiles
{
    public static string Of(string name, IReadOnlyList<(string Label, Point3 At)> points)
    {
        (string Label, char Axis, string Value)[] axes =
        [
            .. points.SelectMany(p => new[] { ('X', p.At.X), ('Y', p.At.Y), ('Z', p.At.Z) }.Select(a => (p.Label, a.Item1, Text(a.Item2)))),
        ];
        return Path.GetExtension(name) switch
        {
            ".qif" => Qif(points),
            ".dfq" => Aqdef(axes),
            ".dmo" => "FILNAM/'S',05.2\nUNITS/MM,ANGDEC\n" + string.Concat(points.Select(Actual)),
            _ when name.EndsWith("_chr.txt", StringComparison.Ordinal) =>
                "planid\tpartnb\tid\ttype\tactual\tfeatureid\tunit\n"
                    + string.Concat(axes.Select(a =>
                        $"S\t1\t{a.Label}_{a.Axis}\t{char.ToLowerInvariant(a.Axis)}Value\t{a.Value}\t{a.Label}\tmm\n")),
            _ => string.Concat(axes.Select(a =>
                (a.Axis == 'X' ? $"DIM L= LOCATION OF POINT {a.Label}  UNITS=MM\nAX NOMINAL +TOL -TOL MEAS DEV OUTTOL\n" : "")
                    + $"{a.Axis} {a.Value} 0.1 0.1 {a.Value} 0 0 ----#----\n")),
        };
    }

    private static string Actual((string Label, Point3 At) p) =>
        $"FA({p.Label})=FEAT/POINT,CART,{Text(p.At.X)},{Text(p.At.Y)},$\n {Text(p.At.Z)},0,0,1\n";

    private static string Aqdef((string Label, char Axis, string Value)[] axes) =>
        string.Create(CultureInfo.InvariantCulture, $"K0100 {axes.Length}\r\nK1001 1\r\n")
            + string.Concat(axes.Select((a, i) => string.Create(
                CultureInfo.InvariantCulture, $"K2001/{i + 1} {i + 1}\r\nK2002/{i + 1} {a.Label}.{a.Axis}\r\nK2142/{i + 1} mm\r\n")))
            + string.Join('\u000f', axes.Select(a => a.Value + "\u00140"));

    private static string Qif(IReadOnlyList<(string Label, Point3 At)> points) =>
        "<QIFDocument xmlns=\"http://qifstandards.org/xsd/qif3\"><FileUnits><PrimaryUnits><LinearUnit><UnitConversion>"
            + "<Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>"
            + "<Results><MeasurementResultsSet><MeasurementResults><MeasuredFeatures>"
            + string.Concat(points.Select(p =>
                $"<PointFeatureMeasurement><FeatureName>{p.Label}</FeatureName>"
                    + $"<Location>{Text(p.At.X)} {Text(p.At.Y)} {Text(p.At.Z)}</Location></PointFeatureMeasurement>\n"))
            + "</MeasuredFeatures></MeasurementResults></MeasurementResultsSet></Results></QIFDocument>";

    private static string Text(double value) => value.ToString("0.00000", CultureInfo.InvariantCulture);
}
