using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

/// <summary>Short forms for tests that write a file in the source.</summary>
internal static class Text
{
    public static MeasurementFile Read(string text, MeasurementFormat? format = null, string file = "part.csv") =>
        MeasurementReader.Read(Encoding.UTF8.GetBytes(text), file, format ?? MeasurementFormat.Points);

    public static InputException Refused(string text, MeasurementFormat? format = null) =>
        Assert.Throws<InputException>(() => Read(text, format));

    public static MeasurementFormat Format(string json) => MeasurementFormat.FromJson(json);
}
