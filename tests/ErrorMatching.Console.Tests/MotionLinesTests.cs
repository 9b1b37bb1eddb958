using System.Globalization;
using System.Text;

namespace ErrorMatching.Console.Tests;

/// <summary>Each line of <c>nc motion</c> has the numbers that formatting them one by one gives.</summary>
public sealed class MotionLinesTests
{
    [Fact]
    public void A_coordinate_is_printed_with_the_digits_of_its_word()
    {
        var random = new Random(7);
        var (text, expected) = (new StringBuilder("G21 G90 G1 F100\n"), new List<string>());
        for (var i = 0; i < 20_000; i++)
        {
            // A decimal type counts the digits, whatever a double makes of them.
            var decimals = random.Next(0, 10);
            var value = new decimal(random.Next(), random.Next(0, 10_000), 0, random.Next(2) == 0, (byte)decimals);
            value = Math.Round(value % (decimal)Math.Pow(10, 15 - decimals), decimals) / (random.Next(3) == 0 ? 1_000 : 1);
            value = Math.Round(value, 9);
            expected.Add(value.ToString("0.#########", CultureInfo.InvariantCulture));
            text.Append(CultureInfo.InvariantCulture, $"X{value.ToString("0.0########", CultureInfo.InvariantCulture)}\n");
        }

        Assert.Equal(expected.Select(e => e == "-0" ? "0" : e), Cells(text.ToString(), "x"));
    }

    [Fact]
    public void A_number_that_no_word_states_is_rounded_to_nine_decimals()
    {
        var random = new Random(8);
        var (text, expected) = (new StringBuilder("G20 G90 G1 F100\n"), new List<double>());
        for (var i = 0; i < 20_000; i++)
        {
            var value = (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-5, 12));
            var inches = value.ToString("0.0######", CultureInfo.InvariantCulture);
            expected.Add(Math.Round(double.Parse(inches, CultureInfo.InvariantCulture) * 25.4, 10));
            text.Append(CultureInfo.InvariantCulture, $"Y{inches}\n");
        }

        Assert.Equal(
            expected.Select(e => (Math.Round(e, 9) + 0.0).ToString("0.#########", CultureInfo.InvariantCulture)),
            Cells(text.ToString(), "y"));
    }

    [Fact]
    public void A_line_has_all_fields()
    {
        const string Text = "N10 G21 G90 G17 G0 X0 Y0 Z5.\nn 20 G1 Z-1.5 F250.5\nG2 X10. Y0 I5. J0\n/N30 (c) G18 G3 X0 Z-1.5 R5.\nX1";
        var lines = Lines(Text + "\n", "linuxcnc", "--block-skip", "off");
        Assert.Equal(
            [
                "index,line,block,kind,x,y,z,cx,cy,cz,plane,turns,feed",
                "0,1,N10,rapid,0,0,5,,,,XY,0,0",
                "1,2,n 20,line,0,0,-1.5,,,,XY,0,250.5",
                "2,3,,arc-cw,10,0,-1.5,5,0,-1.5,XY,0,250.5",
            ],
            lines[..4]);
        Assert.Equal("3,4,N30,arc-ccw,0,0,-1.5,5,0,-1.5,ZX,0,250.5", lines[4]);
    }

    private static IEnumerable<string> Cells(string program, string field)
    {
        var lines = Lines(program, "generic");
        var column = Array.IndexOf(lines[0].Split(','), field);
        return lines[1..].Select(l => l.Split(',')[column]);
    }

    private static string[] Lines(string program, string dialect, params string[] options)
    {
        var file = Path.GetTempFileName();
        try
        {
            File.WriteAllText(file, program);
            return Shell.Run(["nc", "motion", file, "--dialect", dialect, .. options]).Output.TrimEnd('\n').Split('\n');
        }
        finally
        {
            File.Delete(file);
        }
    }
}
