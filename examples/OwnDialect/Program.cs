// A dialect of your own continues one that is built in and states only what differs. Each statement names its source.
using ErrorMatching.Nc;

var dialect = NcDialects.Parse(
    """
    {
      "name": "our-mill", "like": "fanuc", "description": "The mill in hall 2.",
      "codes": [
        { "codes": "G187", "means": "harmless", "statement": "Sets the accuracy at corners.", "source": "the builder's manual, 4.2" }
      ]
    }
    """u8.ToArray(),
    "our-mill.json");
var program = "N10 G187\nN20 G90 G21 G17 G0 X0. Y0. Z5.\nN30 G1 Z0. F300\nN40 X10.\n"u8.ToArray();

foreach (var (name, read) in new[] { ("fanuc", NcDialects.Named("fanuc")), ("our-mill", dialect) })
{
    var path = NcInterpreter.Run(NcProgram.Read(program, read.Syntax), read);
    Console.WriteLine($"{name}: {path.Motions.Length} motions, {path.Problems.Count} problems");
}
