using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>A wish that was written and read again is the same wish; a broken one is refused with its place.</summary>
public sealed partial class WishFileTests
{
    private const string Program = "N10 G90 G17 G0 X0. Y0.\nN20 G1 X10. F100\nN30 G3 X15. Y5. I0. J5.\nG1 Y20.\nN50 X0.\n";

    [Fact]
    public void Every_bit_of_a_wish_survives_the_file() => Prop.ForAll<NormalFloat[]>(numbers =>
    {
        var v = numbers.Select(n => Math.IEEERemainder(n.Get, 1000)).Concat(Enumerable.Repeat(1.0 / 3, 12)).ToArray();
        var wish = DisplacementWish.OfElements(
            [new(1, new(v[0], v[1]), new(v[2], v[3]), new(v[4], v[5])), new(2, new(v[6], v[7]), new(v[8], v[9]), new(v[6], v[7]), true)]);
        var again = Again(Bench.Read(Program), wish, "(MARK \"\u00e9\")");
        Assert.Equal(wish.Elements, again.Wish.Elements);
        Assert.Equal("(MARK \"\u00e9\")", again.Marker);

        var ends = Again(Bench.Read(Program), DisplacementWish.OfEndPoints([3, 1], new(v[0], v[1], v[2])), null);
        Assert.Equal([1, 3], ends.Wish.EndPoints);
        Assert.Equal(new Vector3(v[0], v[1], v[2]), ends.Wish.By);
        Assert.Null(ends.Marker);
    }).QuickCheckThrowOnFailure();

    [Fact]
    public void A_wish_is_one_line_a_motion_with_its_block_for_people()
    {
        var path = Bench.Read(Program);
        var lines = Text(
            path,
            DisplacementWish.OfElements([new(3, new(0.1, 0), new(0.1, 0), new(0.1, 0)), new(1, new(0, 0.1), new(0, 0.2), new(0, 0.3))]))
            .Split('\n');
        Assert.Equal("{", lines[0]);
        Assert.Equal("    {\"block\":\"N20\",\"line\":2,\"motion\":1,\"start\":[0,0.1],\"middle\":[0,0.2],\"end\":[0,0.3]},", lines[7]);
        Assert.Equal("    {\"block\":\"\",\"line\":4,\"motion\":3,\"start\":[0.1,0]}", lines[8]);
        Assert.Equal(["  ]", "}", ""], lines[9..]);
    }

    [Fact]
    public void A_wish_for_nothing_stays_one()
    {
        var again = Again(Bench.Read(Program), DisplacementWish.OfElements([]), null);
        Assert.Empty(again.Wish.Elements);
        Assert.Empty(again.Wish.EndPoints);
    }

    [Fact]
    public void A_wish_is_about_the_bytes_of_one_program()
    {
        var file = Again(Bench.Read(Program), DisplacementWish.Normal(Bench.Read(Program), [1], 0.1).Result!, null);
        Assert.True(file.IsAbout(Bench.Read(Program), "w.json"));
        Assert.False(file.IsAbout(Bench.Read(Program + "\n"), "w.json"));
    }

    [Theory]
    [InlineData("\"errormatch/wish/1\"", "\"errormatch/wish/2\"", "not-one-of", "$.schema")]
    [InlineData("\"generic\"", "7", "wrong-type", "$.dialect")]
    [InlineData("\"marker\"", "\"market\"", "missing-key", "$")]
    [InlineData("0.001", "0", "too-small", "$.leastIncrementMm")]
    [InlineData("\"motion\":1", "\"motion\":1.5", "wrong-type", "$.elements[0].motion")]
    [InlineData("\"motion\":1", "\"motion\":-1", "too-small", "$.elements[0].motion")]
    [InlineData("\"motion\":1", "\"motion\":2147483648", "too-large", "$.elements[0].motion")]
    [InlineData("\"motion\":2", "\"motion\":1", "motion-twice", "$.elements[1]")]
    [InlineData("[0,0.1]", "[0]", "too-few-items", "$.elements[0].start")]
    [InlineData("[0,0.1]", "[0,0.1,0]", "too-many-items", "$.elements[0].start")]
    [InlineData("[0,0.1]", "[0,\"0.1\"]", "wrong-type", "$.elements[0].start[1]")]
    [InlineData("[0,0.1]", "[0,1e7]", "too-large", "$.elements[0].start[1]")]
    [InlineData("\"elements\"", "\"endPoints\": {\"by\":[0,0,0],\"motions\":[]}, \"elements\"", null, null)]
    [InlineData("[0,0.1]", "[0,0.1", "not-json", "$")]
    public void A_broken_wish_is_refused_with_its_place(string was, string now, string? code, string? path)
    {
        var text = TwoElements();
        Assert.Contains(was, text, StringComparison.Ordinal);
        var at = text.IndexOf(was, StringComparison.Ordinal);
        var problem = Assert.Throws<InputException>(() => Read(text[..at] + now + text[(at + was.Length)..])).Refusals[0];
        Assert.True(code is null || (problem.Code, problem.Place.Path) == (code, path), problem.ToString());
    }

    [Theory]
    [InlineData("\"line\":2", "\"line\":3", "no-such-motion")]
    [InlineData("\"block\":\"N20\"", "\"block\":\"N21\"", "no-such-motion")]
    [InlineData("\"motion\":1", "\"motion\":99", "no-such-motion")]
    [InlineData("\"N20\",\"line\":2,\"motion\":1", "\"N10\",\"line\":1,\"motion\":0", "no-element")]
    [InlineData("\"start\":[0,0.1]}", "\"start\":[0,0.1],\"end\":[-10,0.1]}", "no-element")]
    [InlineData("0.001", "0.5", "increment-too-coarse")]
    public void A_wish_that_names_what_the_program_does_not_have_is_refused(string was, string now, string code)
    {
        var text = TwoElements();
        Assert.Contains(was, text, StringComparison.Ordinal);
        var file = Read(text.Replace(was, now, StringComparison.Ordinal));
        var problem = Assert.Single(Assert.Throws<InputException>(() => file.IsAbout(Bench.Read(Program), "w.json")).Refusals);
        Assert.Equal(code, problem.Code);
        Assert.Equal(code == "increment-too-coarse" ? 1 : 8, problem.Place.Line);
    }

    [Fact]
    public void Whatever_a_digit_of_a_wish_becomes_the_proof_fails_or_the_file_is_refused()
    {
        var path = Bench.Read(Program);
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N20..N30"), 0.1).Result!;
        var result = Bench.Rewritten(path, wish).Program;
        var text = Text(path, wish);
        var tampered = 0;
        foreach (Match number in Numbers().Matches(text, text.IndexOf("elements", StringComparison.Ordinal)))
        {
            // Thousandths are within the rounding of the program, and so is what is far smaller.
            var point = number.Value.IndexOf('.', StringComparison.Ordinal);
            for (var i = 0; !number.Value.Contains('E', StringComparison.Ordinal) && i < number.Length && (point < 0 || i < point + 3); i++)
            {
                if (char.IsAsciiDigit(number.Value[i]))
                {
                    var at = number.Index + i;
                    var other = text[..at] + (char)(text[at] == '9' ? '1' : text[at] + 1) + text[(at + 1)..];
                    Assert.False(Holds(other), other);
                    tampered++;
                }
            }
        }

        Assert.InRange(tampered, 15, 60);

        bool Holds(string document)
        {
            try
            {
                var file = Read(document);
                return file.IsAbout(path, "w.json") && Prover.Check(path, result, file.Wish, file.LeastIncrementMm, file.Marker).Holds;
            }
            catch (InputException)
            {
                return false;
            }
        }
    }

    private static string TwoElements()
    {
        var path = Bench.Read(Program);
        return Text(
            path,
            DisplacementWish.OfElements([new(1, new(0, 0.1), new(0, 0.1), new(0, 0.1)), new(2, new(0, 0.4), new(0, 0.2), new(0, 0.3))]));
    }

    private static WishFile Again(NcPath path, DisplacementWish wish, string? marker) => Read(Text(path, wish, marker));

    private static string Text(NcPath path, DisplacementWish wish, string? marker = null)
    {
        using var stream = new MemoryStream();
        WishFile.Of(path, wish, 0.001, marker).WriteTo(stream);
        return Encoding.UTF8.GetString(stream.ToArray());
    }

    [GeneratedRegex(@"[0-9]+(\.[0-9]+)?(E-[0-9]+)?", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Numbers();

    private static WishFile Read(string text) => WishFile.Read(Encoding.UTF8.GetBytes(text), "w.json");
}
