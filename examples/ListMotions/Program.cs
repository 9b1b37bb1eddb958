// Lists what a program does: ListMotions PROGRAM DIALECT prints each motion in the plane, and what the control would not do.
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

try
{
    var dialect = NcDialects.Named(args[1]);
    var program = NcProgram.Read(File.ReadAllBytes(args[0]), dialect.Syntax);
    var path = NcInterpreter.Run(program, dialect);
    foreach (var motion in path.Motions)
    {
        if (motion.MovesInPlane)
        {
            var (block, kind) = (program.NameOf(program[motion.Block]), motion.IsArc ? "arc" : motion.IsCut ? "line" : "rapid");
            Console.WriteLine(FormattableString.Invariant(
                $"{block}: {kind} to X{motion.PlaneEnd.X:0.###} Y{motion.PlaneEnd.Y:0.###}, {motion.PlaneLength:0.###} mm"));
        }
    }

    foreach (var problem in path.Problems)
    {
        Console.WriteLine($"{program.NameOf(program[problem.Block])}: {problem.Message}");
    }

    return 0;
}
catch (InputException e)
{
    Console.Error.WriteLine(e.Message);
    return 1;
}
