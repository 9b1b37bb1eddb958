using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class MutationTests
{
    private static readonly (string Text, MeasurementFormat Format)[] Seeds =
    [
        ("point,x_mm,y_mm,z_mm\nA,1.5,2,3\n\"B\"\"b\",-1e-3,2,3\r\n5,.5,\"6\",7\n", MeasurementFormat.Points),
        (
            "Serial: 4\nfeature,item,nominal,actual,deviation,tolerance\nP1,X,48.050,47.932,-0.118,0.05\nP1,Y,1,1,0,0\nP1,Z,1,1,0,0\n",
            MeasurementFormat.FeatureTable with { SkipLines = 1 }),
        (
            "Nr;x;y\n1;-32,067;76,005\n",
            MeasurementFormat.FromJson(
                """{ "delimiter": ";", "decimalComma": true, "unit": "inch", "encoding": "gb18030", "columns": { "label": 1, "x": "x", "y": 3 } }""")),
        ("p\0o\0i\0n\0t\0,\0x\0_\0m\0m\0,\0y\0_\0m\0m\0\n\0A\0,\01\0,\02\0", MeasurementFormat.Points with { Encoding = "utf-16" }),
    ];

    [Fact]
    public void Random_bytes_are_read_or_named_and_nothing_else()
    {
        var random = new Random(20210405);
        var (read, named) = (0, 0);
        for (var i = 0; i < 40_000; i++)
        {
            var (text, format) = Seeds[i % Seeds.Length];
            try
            {
                var file = MeasurementReader.Read(Mutate(Encoding.UTF8.GetBytes(text), random), "m.csv", format);
                Assert.All(file.Points, p => Assert.True(p.Position.IsFinite && p.Label.Length > 0 && p.Line > 0));
                read++;
            }
            catch (InputException e)
            {
                Assert.True(e.Place.Line >= 1 && e.Place.Column >= 1 && e.File == "m.csv" && e.Code.Length > 0, e.Message);
                Assert.DoesNotContain(e.Message, char.IsControl);
                named++;
            }
        }

        Assert.True(read > 1000 && named > 10_000, $"{read} read, {named} named");
    }

    [Fact]
    public void Random_descriptions_are_read_or_named_and_nothing_else()
    {
        var random = new Random(20190101);
        var seed = """{"kind":"points","encoding":"utf-8","delimiter":";","decimalComma":true,"skipLines":3,"unit":"mm","columns":{"label":1,"x":"X","y":"Y","z":null},"maxBytes":9,"maxPoints":8}"""u8
            .ToArray();
        for (var i = 0; i < 20_000; i++)
        {
            var json = Encoding.UTF8.GetString(Mutate(seed, random));
            try
            {
                _ = MeasurementFormat.FromJson(json);
            }
            catch (InputException e)
            {
                Assert.Equal(MeasurementError.BadFormat, e.Code);
            }
        }
    }

    internal static byte[] Mutate(byte[] bytes, Random random)
    {
        var list = bytes.ToList();
        ReadOnlySpan<byte> favorites = "\",;.\n\r-+=eE0 9\0\t:@X"u8;
        for (var n = random.Next(1, 5); n > 0 && list.Count > 0; n--)
        {
            var at = random.Next(list.Count);
            var value = random.Next(2) == 0 ? (byte)random.Next(256) : favorites[random.Next(favorites.Length)];
            switch (random.Next(5))
            {
                case 0: list[at] = value; break;
                case 1: list.Insert(at, value); break;
                case 2: list.RemoveAt(at); break;
                case 3: list.RemoveRange(at, random.Next(list.Count - at)); break;
                default: list.InsertRange(at, list.GetRange(at, random.Next(list.Count - at))); break;
            }
        }

        return [.. list];
    }
}
