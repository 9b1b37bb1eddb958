using System.CommandLine;
using System.Globalization;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc displace</c>.</summary>
internal sealed class NcDisplace : NcVerb
{
    private readonly BlocksOption _blocks = new();
    private readonly Option<string> _by = new("--by")
    {
        Description = "Moves the end points of the named motions by a vector in mm.",
        HelpName = "DX,DY[,DZ]"
    };
    private readonly Option<string> _normal = new("--normal")
    {
        Description = "Moves the named elements by a distance in mm to the left of travel; negative: to the right.",
        HelpName = "D"
    };
    private readonly Option<string> _along = new("--along")
    {
        Description = "Moves the named elements as points with the columns x, y, dx and dy say.",
        HelpName = "POINTS.csv"
    };
    private readonly WishOption _wish = new();
    private readonly CertificateOption _certificate = new();
    private readonly Option<string> _out = new("--out")
    {
        Description = "The program to write, or - for standard output; the answer then goes to standard error.",
        HelpName = "FILE",
        Required = true
    };

    public NcDisplace()
        : base(
            "displace",
            "Moves named blocks, changes the fewest words, and proves what it changed.",
            "errormatch nc displace samples/complex-mating/counterpart.nc --dialect delta-nc300 --blocks N130..N160 --normal 0.02 --out "
                + "out/displaced.nc")
    {
        Options.Add(_blocks);
        Options.Add(_by);
        Options.Add(_normal);
        Options.Add(_along);
        Options.Add(_out);
        Options.Add(_wish);
        Options.Add(_certificate);
        Demand(_by, text => Vector(text) is { Length: 2 or 3 }, "two or three numbers such as 0.1,-0.05");
        Demand(_normal, text => Vector(text) is { Length: 1 }, "a number such as -0.02");
        Validators.Add(result =>
        {
            if (new Option[] { _by, _normal, _along }.Count(o => result.GetResult(o) is not null) != 1)
            {
                result.AddError("Exactly one of --by, --normal and --along says how the blocks are displaced.");
            }

            if (result.GetValue(_out) == StandardInput.Dash && result.GetValue<bool>("--json"))
            {
                result.AddError("--json and --out - both need standard output. Name a file for the program.");
            }
        });
    }

    protected override VerbResult Run(string file, NcPath path, ParseResult arguments, CancellationToken cancellation)
    {
        var blocks = _blocks.Select(arguments, path.Program);
        if (!blocks.IsUsable)
        {
            return FailureOf.Refused(file, blocks.Refusal);
        }

        double? misfit = null;
        Outcome<DisplacementWish> wish;
        if (arguments.GetValue(_by) is { } by)
        {
            var vector = Vector(by)!;
            wish = DisplacementWish.EndsBy(path, blocks.Result, new(vector[0], vector[1], vector.Length > 2 ? vector[2] : 0));
        }
        else if (arguments.GetValue(_normal) is { } normal)
        {
            wish = DisplacementWish.Normal(path, blocks.Result, Vector(normal)![0]);
        }
        else
        {
            var pointwise = PointwiseWish.Of(path, blocks.Result, Points(arguments.GetRequiredValue(_along)));
            misfit = pointwise.Result?.LargestMisfitMm;
            wish = pointwise.IsUsable ? pointwise.Result.Wish : pointwise.Refusal;
        }

        return wish.IsUsable ? Displace(file, path, wish.Result, misfit, arguments, cancellation) : FailureOf.Refused(file, wish.Refusal);
    }

    private VerbResult Displace(
        string file, NcPath path, DisplacementWish wish, double? misfit, ParseResult arguments, CancellationToken cancellation)
    {
        var rewrite = Rewriter.Apply(path, wish);
        if (!rewrite.IsUsable)
        {
            return FailureOf.Refused(file, rewrite.Refusal);
        }

        var output = arguments.GetRequiredValue(_out);
        var isPiped = output == StandardInput.Dash;
        string[] inputs = [
            file, .. path.Dialect.Files.Select(f => f.File), .. arguments.GetValue(_along) is { } along ? [along] : Array.Empty<string>()];

        // The program is written to disk during the proof, and gets its name if the proof succeeds. A missing folder is created only then.
        var proving = Task.Run(
            () => Prover.Check(path, rewrite.Result.Program, wish, rewrite.Result.LeastIncrementMm), CancellationToken.None);
        if (isPiped || !Directory.Exists(Path.GetDirectoryName(Path.GetFullPath(output))))
        {
            proving.Wait(CancellationToken.None);
        }

        if (!proving.IsCompleted || Proof().Holds)
        {
            try
            {
                // A certificate states the proof, so it waits for it.
                var outputs = arguments.GetValue(_certificate) is null || Proof().Holds
                    ? _certificate.Before(isPiped ? [] : [(output, rewrite.Result.Program.Bytes)], Certified, arguments)
                    : [];
                outputs = _wish.Before(outputs, () => WishFile.Of(path, wish, rewrite.Result.LeastIncrementMm), arguments);
                if (outputs.Count > 0)
                {
                    OutputFile.WriteAll(outputs, inputs, () => Proof().Holds, cancellation);
                }
            }
            catch (OutputException) when (!Proof().Holds)
            {
                // If the program must not be used, report that reason, not an output error.
            }
        }

        return Proof() is { Holds: true } proof
            ? new NcDisplaceAnswer(file, isPiped ? null : output, path, rewrite.Result, proof, misfit)
            : FailureOf.Refused(file, Proof().Failures);

        NcProof Proof() => proving.GetAwaiter().GetResult();

        Certificate Certified() => Certificate.Of(path, rewrite.Result.Program, wish, rewrite.Result.LeastIncrementMm, Proof());
    }

    private List<DisplacedPoint> Points(string file)
    {
        var table = Numbers(file, "x", "y", "dx", "dy");
        return [
            .. Enumerable.Range(0, table.Count).Select(i => new DisplacedPoint(
                new(At("x", i), At("y", i)), new(At("dx", i), At("dy", i))))];

        double At(string column, int row) => double.Parse(table[column][row], NumberStyles.Float, CultureInfo.InvariantCulture);
    }

    private static double[]? Vector(string text)
    {
        var parts = text.Split(',');
        var numbers = new double[parts.Length];
        for (var i = 0; i < parts.Length; i++)
        {
            const NumberStyles Plain = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;
            if (!double.TryParse(parts[i], Plain, CultureInfo.InvariantCulture, out numbers[i]) || !double.IsFinite(numbers[i]))
            {
                return null;
            }
        }

        return numbers;
    }
}
