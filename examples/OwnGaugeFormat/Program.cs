// The files of a gauge are described as data: what separates cells, which column is which, and the unit.
using System.Globalization;
using System.Text;
using ErrorMatching.Measurement;

var format = MeasurementFormat.FromJson(
    """{ "kind": "points", "delimiter": ";", "decimalComma": true, "skipLines": 2, "columns": { "label": "Nr", "x": "X", "y": "Y" } }""");
var file = MeasurementReader.Read(
    Encoding.UTF8.GetBytes("Gauge 4711\nPart: cover\nNr;X;Y\n1;10,003;0,098\n2;39,998;0,102\n"), "cover.txt", format);
foreach (var point in file.Points)
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{point.Label}: {point.Position.X} {point.Position.Y}"));
