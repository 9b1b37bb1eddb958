// Most tests wait for programs and disks most of the time; what they need of the processor leaves room for one test more than there are
// cores on a small computer.
[assembly: Xunit.v3.Parallelization(MaxThreads = 3)]
