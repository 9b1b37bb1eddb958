using System.Globalization;
using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Writes the moves of a random part's program in Heidenhain Klartext, with the same block numbers.</summary>
internal static class KlartextWriter
{
    /// <summary>The part with a program in Klartext: positions or increments, arcs by center, angle or radius, as its flavor and number
    /// say.</summary>
    public static RandomPart InKlartext(RandomPart part)
    {
        var text = new StringBuilder($"0 BEGIN PGM PART{part.Seed.ToString(CultureInfo.InvariantCulture)} MM\r\n");
        text.Append("1 BLK FORM 0.1 Z X-500 Y-500 Z-50\r\n2 BLK FORM 0.2 X+500 Y+500 Z+0\r\n")
            .Append("3 TOOL CALL 1 Z S6000\r\n4 L X+0 Y+0 Z+0 R0 FMAX M3\r\n");
        var side = CutterSide.None;
        foreach (var move in RefereeInterpreter.Run(part.Program))
        {
            var number = int.Parse(move.Block.AsSpan(1), CultureInfo.InvariantCulture);

            // Behind an arc to an angle, each block states both coordinates.
            var toAngle = part.Seed % 4 == 3;
            var by = part.Flavor.Incremental && !move.Rapid && !toAngle;
            var end = new StringBuilder();
            Coordinate(end, 'X', move.From.X, move.To.X, by, move.IsArc || toAngle);
            Coordinate(end, 'Y', move.From.Y, move.To.Y, by, move.IsArc || toAngle);
            Coordinate(end, 'Z', move.From.Z, move.To.Z, by, always: false);
            var sense = move.Sweep > 0 ? " DR+" : " DR-";
            if (move.IsArc && part.Flavor.RadiusArcs && Math.Abs(move.Sweep) is > 0.35 and < 2.6 && part.Seed % 3 > 0)
            {
                text.Append(CultureInfo.InvariantCulture, $"{number} CR{end} R{move.Radius:+0.###}{sense}");
            }
            else if (move.IsArc)
            {
                var center = new StringBuilder();
                Coordinate(center, 'X', move.From.X, move.Center.U, part.Seed % 5 == 0, always: true);
                Coordinate(center, 'Y', move.From.Y, move.Center.V, part.Seed % 5 == 0, always: true);

                // An angle that leads to the same place within a micrometer, as some post processors write arcs.
                var angle = toAngle
                    ? string.Create(CultureInfo.InvariantCulture, $" IPA{move.Sweep * 180 / Math.PI:+0.######;-0.######}")
                    : "";
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"{number - 5} CC{center}\r\n{number} {(angle.Length > 0 ? "CP" + angle : "C" + end)}{sense}");
            }
            else
            {
                text.Append(CultureInfo.InvariantCulture, $"{number} L{end}");
            }

            text.Append(move.Side == side ? "" : move.Side switch { CutterSide.Left => " RL", CutterSide.Right => " RR", _ => " R0" })
                .Append(move.Rapid ? " FMAX" : number < 100 ? " F500" : "")
                .Append("\r\n");
            side = move.Side;
        }

        return part with { Program = text.Append("9998 M30\r\n9999 END PGM PART MM\r\n").ToString() };
    }

    private static void Coordinate(StringBuilder text, char axis, double from, double to, bool incremental, bool always)
    {
        if (always || from != to)
        {
            var value = Math.Round(incremental ? to - from : to, 3);
            text.Append(CultureInfo.InvariantCulture, $" {(incremental ? "I" : "")}{axis}{value:+0.###;-0.###;+0}");
        }
    }
}
