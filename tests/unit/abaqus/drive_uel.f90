! Calls the user element UEL as Abaqus/Standard does, increment by increment. The file motion.txt gives the numbers of
! laws and of points. For each law it gives the type of the element, the number of variables, the time step, and the
! displacement and velocity at each point. The program prints a line for each point: the force from RHS, the element
! (1, 1) of AMATRX, of the stiffness matrix and of the damping matrix, and the work.
program drive_uel
  implicit none
  integer, parameter :: most = 4096
  integer :: laws, law, kind, variables, points, i, task, unit
  double precision :: step, off
  double precision, allocatable :: x(:), v(:)
  double precision :: svars(most), tried(most), energy(8), tried_energy(8), rhs(2, 1), matrix(2, 2), k(2, 2), c(2, 2), worst
  open (newunit=unit, file='motion.txt', status='old')
  read (unit, *) laws, points
  allocate (x(0:points), v(0:points))
  do law = 1, laws
    read (unit, *) kind, variables, step
    do i = 1, points
      read (unit, *) x(i), v(i)
    end do
    x(0) = 0
    v(0) = 0
    svars = 0
    energy = 0
    do i = 1, points
      ! Abaqus repeats an increment until it converges, and cuts it back where it does not converge. The element is
      ! therefore called twice at wrong displacements, and at every fifth point once for an increment over two points.
      ! The results of these calls are dropped.
      do task = 1, 3
        if (task == 3 .and. (mod(i, 5) /= 0 .or. i == points)) cycle
        off = merge(-0.7d0, 1.3d0, task == 1)
        tried = svars
        tried_energy = energy
        if (task == 3) then
          call asked(kind, 11, 1, x(i + 1), v(i + 1), x(i + 1) - x(i - 1), 2 * step, tried, variables, tried_energy, rhs, matrix)
        else
          call asked(kind, 11, 1, off * x(i), v(i), off * x(i) - x(i - 1), step, tried, variables, tried_energy, rhs, matrix)
        end if
      end do
      ! Calls that ask for the stiffness, damping or mass matrix or for a residual alone must not change the element's
      ! variables and energies. The element has no mass.
      tried = svars
      tried_energy = energy
      call asked(kind, 11, 2, x(i), v(i), x(i) - x(i - 1), step, svars, variables, energy, rhs, k)
      call asked(kind, 11, 3, x(i), v(i), x(i) - x(i - 1), step, svars, variables, energy, rhs, c)
      call asked(kind, 11, 4, x(i), v(i), x(i) - x(i - 1), step, svars, variables, energy, rhs, matrix)
      if (any(matrix /= 0)) print *, 'a mass'
      call asked(kind, 11, 5, x(i), v(i), x(i) - x(i - 1), step, svars, variables, energy, rhs, matrix)
      if (any(matrix /= 0) .or. any(tried /= svars) .or. any(tried_energy /= energy)) print *, 'traces'
      call asked(kind, 11, 1, x(i), v(i), x(i) - x(i - 1), step, svars, variables, energy, rhs, matrix)
      worst = max(abs(matrix(1, 1) - matrix(2, 2)), abs(matrix(1, 1) + matrix(1, 2)), abs(matrix(1, 2) - matrix(2, 1)), &
                  abs(rhs(1, 1) + rhs(2, 1)))
      if (worst /= 0) print *, 'no equilibrium', worst
      print '(5es25.16)', rhs(1, 1), matrix(1, 1), k(1, 1), c(1, 1), energy(4)
    end do
    if (any(svars(variables + 1:) /= 0)) print *, 'more variables than were given'
  end do

contains

  subroutine asked(kind, procedure, task, disp, velocity, increment, step, svars, variables, energy, rhs, matrix)
    integer, intent(in) :: kind, procedure, task, variables
    double precision, intent(in) :: disp, velocity, increment, step
    double precision, intent(inout) :: svars(most), energy(8), rhs(2, 1), matrix(2, 2)
    double precision :: props(1), coords(3, 2), u(2), du(2, 1), vel(2), acc(2), time(2), params(3), adlmag(1, 1), ddlmag(1, 1)
    double precision :: predef(2, 1, 2), pnewdt, period
    integer :: flags(5), jdltyp(1, 1), jprops(1)
    props = 1.5d0
    coords = 0
    u = [0d0, disp]
    ! A displacement that both nodes share causes no force.
    du(:, 1) = [0.125d0, 0.125d0 + increment]
    vel = [0.5d0, 0.5d0 + velocity]
    acc = 0
    time = 0
    params = [0d0, 0.25d0, 0.5d0]
    adlmag = 0
    ddlmag = 0
    predef = 0
    pnewdt = 1
    period = 0
    flags = [procedure, 0, task, 0, 0]
    jdltyp = 0
    jprops = 0
    rhs = 7
    matrix = 7
    call uel(rhs, matrix, svars, energy, 2, 1, variables, props, 1, coords, 3, 2, u, du, vel, acc, kind, time, step, 1, 1, 1, &
             params, 0, jdltyp, adlmag, predef, 1, flags, 2, ddlmag, 1, pnewdt, jprops, 0, period)
    if (pnewdt /= 1) print *, 'a smaller step is asked for'
  end subroutine asked
end program drive_uel

! Stand-ins for the routines that Abaqus offers to user subroutines.
subroutine xit
  stop 3
end subroutine xit

subroutine stdb_abqerr(severity, text, integers, reals, words)
  implicit none
  integer :: severity, integers(*)
  double precision :: reals(*)
  character(len=*) :: text
  character(len=8) :: words(*)
  print *, 'STDB_ABQERR', severity, text
end subroutine stdb_abqerr
